// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/StageClock.h"
#include "Core/Location/Locator.h"
#include "Trace/Frame.h"
#include "Trace/Surface.h"

#include <functional>
#include <memory>
#include <vector>

namespace pixelexact
{
/// What is rendered. Locator and field must outlive the scene.
struct Scene
{
  const Locator* locator = nullptr;
  const Field* field = nullptr;
  /// Component of the field that becomes the value; kMagnitude: the Euclidean norm of all, which
  /// for a scalar field is the scalar itself, sign and all, as in VTK.
  int component = 0;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  /// Of the values; see FrameCounters::floatCheck for what Float costs. Not with enclosures.
  Precision precision = Precision::Double;

  static constexpr int kMagnitude = -1;
};

/// The samples and buffers that something after the rays needs.
struct SampleNeeds
{
  Buffer centres = Buffer::None;
  Buffer corners = Buffer::None;
};

/// Whatever works on the image after the rays (paper, section 5.1): colour map, contours, lights.
/// It says what it needs; the tracer casts the union of all needs, once.
class FrameModule
{
public:
  virtual ~FrameModule() = default;
  [[nodiscard]] virtual SampleNeeds Needs() const = 0;
  virtual void Process(Frame& frame) const = 0;
};

/// Called from the calling thread's share of the work with the part done, 0 to 1; returning false
/// aborts the frame. May be empty.
using Progress = std::function<bool(double)>;

/// Casts the rays that the modules (and `extra`) need, locates and evaluates the hits, and runs the
/// modules in order. Front to back: a hit outside of the mesh lets the ray go on to the next
/// surface. Parallel over tiles; the frame is the same, bit for bit, for any number of threads.
/// Throws Error for a scene that cannot be traced (RequireTraceable); an aborted frame comes back
/// with the tiles not done as Nothing. `stages`, where not null, gets the time of each stage added,
/// that of the tiles summed over threads; the frame then takes some percent longer.
Frame Trace(const Scene& scene, const Camera& camera,
  const std::vector<const FrameModule*>& modules, const SampleNeeds& extra = {},
  const Progress& progress = {}, StageTimes* stages = nullptr);
} // namespace pixelexact
