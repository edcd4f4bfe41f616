// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ClippedSurface.h"
#include "FieldChoice.h"
#include "PixelExactRenderingModule.h"
#include "Trace/ProgressiveFrame.h"
#include "VtkCamera.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkImplicitFunction;
class vtkScalarsToColors;
class vtkUnstructuredGrid;

namespace pixelexact
{
class HighOrderModel;

/// What is to be seen. The objects are the caller's; all spaces are the data's.
struct FrameRequest
{
  vtkUnstructuredGrid* grid = nullptr;
  FieldChoice field;
  std::vector<vtkImplicitFunction*> cuts;
  std::vector<KeptHalfSpace> kept; ///< clipping planes, and the near plane where it cuts the data
  CameraSetup camera;
  /// Null: every exact pixel gets the solid colour.
  vtkScalarsToColors* table = nullptr;
  std::array<std::uint8_t, 4> solidColor{ 255, 255, 255, 255 };
  std::array<std::uint8_t, 4> unknownColor{ 255, 0, 255, 255 };
  /// Beyond what drawing needs.
  Buffer buffers = Buffer::None;
  /// What tracing may take. Where the frame is expected to take longer it is made coarse, and finer
  /// by each further call with the same scene.
  double seconds = std::numeric_limits<double>::infinity();
};

/// How often each step was taken.
struct FrameSourceCounters
{
  std::int64_t models = 0;
  std::int64_t traces = 0;
  std::int64_t colorings = 0;
};

/// Frames of a grid for whoever draws them: mapper, render pass. Keeps the last model and the last
/// frame, and takes only the steps whose inputs changed: another lookup table recolours, another
/// view traces, another grid builds a model. Not for use by several threads at once.
class PIXELEXACTRENDERING_EXPORT FrameSource
{
public:
  FrameSource();
  ~FrameSource();
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  /// The frame asked for; valid until the next call. An aborted frame (see Progress) lacks tiles
  /// and is traced anew by the next call; a coarse one (see FrameRequest::seconds) shows blocks of
  /// pixels alike. Throws Error, after which there is no frame.
  const Frame& Render(const FrameRequest& request, const Progress& progress = {});

  /// The last frame, complete and with all of its buffers, traced once more where some were not
  /// asked for.
  /// Null when there is none.
  const Frame* FrameWithAllBuffers();

  /// The last frame, null when there is none or it failed.
  [[nodiscard]] const Frame* LastFrame() const;

  /// The model of the grid as it is now. Throws Error.
  const std::shared_ptr<HighOrderModel>& ModelOf(vtkUnstructuredGrid* grid);
  /// The model of the last frame; null when there is none.
  [[nodiscard]] const HighOrderModel* Model() const { return TheModel.get(); }

  /// Differs whenever pixels may differ from those seen before.
  [[nodiscard]] std::int64_t Version() const { return TheCounters.traces + TheCounters.colorings; }
  [[nodiscard]] const FrameSourceCounters& Counters() const { return TheCounters; }

  /// Forgets the frame; the model stays.
  void DropFrame();
  /// Forgets model and frame.
  void Clear();

private:
  // An object and its state: modification times are unique, addresses are not.
  using Stamp = std::pair<const void*, std::uint64_t>;
  struct TraceKey
  {
    FieldChoice field;
    int component = 0;
    std::vector<Stamp> cuts;
    std::vector<KeptHalfSpace> kept;
    CameraSetup camera;

    bool operator==(const TraceKey&) const = default;
  };
  struct ColorKey
  {
    // Kept alive, so that no other table can have its address.
    vtkSmartPointer<vtkScalarsToColors> table;
    std::uint64_t state = 0;
    std::array<std::uint8_t, 4> solid{};
    std::array<std::uint8_t, 4> unknown{};

    bool operator==(const ColorKey&) const = default;
  };

  void Update(const FrameRequest& request, const Progress& progress);
  void MakeScene(const FrameRequest& request, const Field& field);
  void BeginFrame(Buffer buffers);
  void TraceFrame(double seconds, const Progress& progress);
  void ColorFrame(ColorKey key);

  std::shared_ptr<HighOrderModel> TheModel;
  Scene TheScene;
  Buffer TheBuffers = Buffer::None; ///< that the frame was traced with
  std::optional<TraceKey> Traced;   ///< of TheScene; none: nothing to show
  std::optional<ColorKey> Colored;
  std::optional<ProgressiveFrame> Passes; ///< of a frame that is not complete
  std::optional<Frame> TheFrame;
  bool Complete = false;
  double PixelSeconds = std::numeric_limits<double>::infinity(); ///< of the last complete frame
  FrameSourceCounters TheCounters;
};
} // namespace pixelexact
