// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FieldChoice.h"
#include "FrameContours.h"
#include "PixelExactRenderingModule.h"
#include "Trace/FrameCost.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/Lighting.h"
#include "Trace/ProgressiveFrame.h"
#include "Trace/TileSamples.h"
#include "VtkCamera.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class vtkScalarsToColors;

namespace pixelexact
{
class HighOrderModel;

/// A cut-surface and how it is shown.
struct LayerRequest
{
  std::shared_ptr<const Surface> surface; ///< another object where it is another surface
  FieldChoice field;
  std::optional<int> component; ///< or kMagnitude; none: the table's choice
  Precision precision = Precision::Double;
  /// Null: every exact pixel gets the solid colour.
  vtkScalarsToColors* table = nullptr;
  /// That of contours on a surface of one colour: their component and, where they have none,
  /// colours.
  vtkScalarsToColors* contourTable = nullptr;
  Rgba solidColor{ 255, 255, 255, 255 };
  double opacity = 1.0;
  std::optional<Material> material; ///< none: not lit
  bool litWhereFlat = false;        ///< also a plane
  LayerContours contours;
};

/// The table that the layer is coloured by, or else its contours are; null: none.
[[nodiscard]] vtkScalarsToColors* TableOf(const LayerRequest& layer);

/// The layer's field. Null where the model has none and none is asked for, by name or to be mapped
/// to colours. Throws Error when there is no such field.
[[nodiscard]] const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model);

/// The component that the layer shows of its field: what it asks for, else the table's choice.
/// Throws Error when the field has no such component.
[[nodiscard]] int ComponentOf(const LayerRequest& layer, const Field& field);

/// What is to be seen. The objects are the caller's; all spaces are the data's, but for lights.
struct FrameRequest
{
  std::shared_ptr<HighOrderModel> model;
  std::vector<LayerRequest> layers;
  std::vector<KeptHalfSpace> kept; ///< clipping planes, and the near plane where it cuts the data
  CameraSetup camera;
  Rgba unknownColor{ 255, 0, 255, 255 };
  std::vector<Light> lights;
  LitView lit;
  bool translucent = false; ///< all of it, for somebody who blends frames over what is there
  /// A table whose range is to be that of the values shown; null: none.
  vtkScalarsToColors* fitted = nullptr;
  std::optional<EdgeStyle> edges; ///< of elements, where they are drawn
  ContourLook contours;           ///< where layers have some
  /// Beyond what drawing needs.
  Buffer buffers = Buffer::None;
  /// What tracing may take. Where the frame takes longer it is made coarse, and finer by each
  /// further call with the same scene.
  double seconds = std::numeric_limits<double>::infinity();
  bool refine = true; ///< whether a coarse frame of the same scene is made finer
  /// Above 1: of each stride x stride pixels the middle one is traced, and all show it. Throws
  /// Error with what is of each pixel: contours, edges.
  int stride = 1;
};

/// How often each step was taken.
struct FrameSourceCounters
{
  std::int64_t traces = 0;
  std::int64_t colorings = 0;
};

/// Frames of one view for whoever draws them: mapper, render pass. Keeps the last frame, and takes
/// only the steps whose inputs changed: another lookup table recolours, another camera or model
/// traces. Not for use by several threads at once.
class PIXELEXACTRENDERING_EXPORT FrameSource
{
public:
  /// Counts in `counters`, which others may share and which must outlive this.
  explicit FrameSource(FrameSourceCounters& counters);
  ~FrameSource();
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  /// The frame asked for, of a model that is not null; valid until the next call. An aborted frame
  /// (see Progress) lacks tiles and is traced anew by the next call; a coarse one (see
  /// FrameRequest::seconds) has only some of the pixels (LastStep). Throws Error, after which there
  /// is no frame.
  const Frame& Render(const FrameRequest& request, const Progress& progress = {});

  /// Samples of the frame asked for at `positions` alone, with the usual buffers and colours; those
  /// of a pixel's centre are the pixel's, bit for bit. There is no frame afterwards. Throws Error.
  SampleBuffers Sample(const FrameRequest& request, std::span<const ImagePosition> positions);

  /// The last frame, complete and with all of its buffers, traced once more where some were not
  /// asked for.
  /// Null when there is none.
  const Frame* FrameWithAllBuffers();

  /// The last frame, null when there is none or it failed.
  [[nodiscard]] const Frame* LastFrame() const;

  /// Pixels between those of the last frame, which has only every so many-th of each row and
  /// column; 1: all of them.
  [[nodiscard]] int LastStep() const { return TheStep; }

  /// Whether there is one, neither coarse nor aborted.
  [[nodiscard]] bool IsComplete() const { return TheFrame && Complete; }

  /// What is known of the last frame's pixels and its contours; null where there are none, or only
  /// a coarse frame.
  [[nodiscard]] const ContourCertifier* LastContours() const
  {
    return TheFrame && Complete ? Contours.Found() : nullptr;
  }

  /// The model of the last frame; null when there is none.
  [[nodiscard]] const HighOrderModel* Model() const { return TheModel.get(); }
  /// Of the last frame.
  [[nodiscard]] const Scene& LastScene() const { return TheScene; }

  /// Differs whenever pixels may differ from those seen before, in this view or another that counts
  /// in the same counters.
  [[nodiscard]] std::int64_t Version() const { return TheVersion; }
  /// Differs whenever positions may.
  [[nodiscard]] std::int64_t TraceVersion() const { return TheTraceVersion; }

  /// Forgets model and frame.
  void DropFrame();

private:
  struct TracedLayer
  {
    // Kept alive, so that no other surface can have its address.
    std::shared_ptr<const Surface> surface;
    FieldChoice field;
    int component = 0;
    Precision precision = Precision::Double;
    bool translucent = false;

    bool operator==(const TracedLayer&) const = default;
  };
  struct TraceKey
  {
    std::vector<TracedLayer> layers;
    std::vector<KeptHalfSpace> kept;
    CameraSetup camera;
    int stride = 1;

    bool operator==(const TraceKey&) const = default;
  };
  struct ColoredLayer
  {
    // Kept alive, so that no other table can have its address.
    vtkSmartPointer<vtkScalarsToColors> table;
    std::uint64_t state = 0;
    bool isSolid = false; ///< the table is that of contours alone
    Rgba solid{};
    double opacity = 1.0;
    std::optional<Material> material;
    LayerContours contours;

    bool operator==(const ColoredLayer&) const = default;
  };
  struct ColorKey
  {
    std::vector<ColoredLayer> layers;
    Rgba unknown{};
    std::vector<Light> lights; ///< where a layer is lit
    LitView lit;
    std::optional<EdgeStyle> edges;
    ContourLook contours;

    bool operator==(const ColorKey&) const = default;
  };

  void Update(const FrameRequest& request, const Progress& progress);
  [[nodiscard]] TraceKey TraceKeyOf(const FrameRequest& request) const;
  [[nodiscard]] ColorKey ColorKeyOf(const FrameRequest& request) const;
  void MakeScene(const FrameRequest& request);
  void MakeColors(const ColorKey& key);
  [[nodiscard]] Pipeline ThePipeline();
  void BeginFrame(Buffer buffers);
  void TraceFrame(double seconds, const Progress& progress);
  void TraceBlocks(Buffer buffers, const Progress& progress);
  /// `aborted`: set by `progress`.
  void TraceInTime(double seconds, const Progress& progress, const bool& aborted);
  [[nodiscard]] double Pixels() const;
  void ShowPreview();
  void Count(bool traced);
  void Forget();
  [[nodiscard]] Buffer AllBuffers() const;

  std::shared_ptr<HighOrderModel> TheModel;
  Scene TheScene;
  Buffer TheBuffers = Buffer::None; ///< that the frame was traced with
  std::optional<TraceKey> Traced;   ///< of TheScene; none: nothing to show
  std::optional<ColorKey> Colored;  ///< what Colors and Lights were made of
  std::optional<ColorMapping> Colors;
  // Not optional, of which g++ 14 believes that it is reset before it holds anything.
  std::unique_ptr<Lighting> Lights;
  std::unique_ptr<ElementEdges> Edges;
  FrameContours Contours;
  std::optional<ProgressiveFrame> Passes; ///< of a frame that is not complete
  std::optional<int> Shown;               ///< the passes' step, of which TheFrame is the preview
  std::optional<Frame> TheFrame;
  Frame Spare; ///< what was shown before: the next one is made in its memory
  int TheStep = 1;
  bool Complete = false;
  FrameCost Cost;
  FrameSourceCounters& TheCounters;
  std::int64_t TheVersion = -1;
  std::int64_t TheTraceVersion = -1;
};
} // namespace pixelexact
