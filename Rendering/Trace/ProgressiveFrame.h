// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Tracer.h"

#include <utility>

namespace pixelexact
{
/// A frame that can be looked at before it is done: pixels far apart first, then those between,
/// each traced once. The complete frame is that of Trace, bit for bit, but for its counters'
/// seconds, which are the sum of the passes'.
class ProgressiveFrame
{
public:
  /// Pixels between the samples of the first pass; each pass halves it.
  static constexpr int kCoarsest = 8;

  /// Makes the pipeline's buffers of centres and those of `extra`; the complete frame has
  /// `corners`, too (KeepCorners). Throws Error for a scene that cannot be traced. What scene and
  /// pipeline refer to must outlive this.
  ProgressiveFrame(Scene scene, const Camera& camera, Pipeline pipeline,
    Buffer extra = Buffer::None, Buffer corners = Buffer::None);

  /// The next pass. False where `progress` aborted it: it is to be made again.
  bool Refine(const Progress& progress = {});
  /// All that is left, in one pass if there was none yet. False as Refine.
  bool Complete(const Progress& progress = {});

  /// From now on in other colours; their buffers of centres must be among those that are made.
  void Recolor(Pipeline pipeline, Buffer corners = Buffer::None)
  {
    ThePipeline = std::move(pipeline);
    Corners = corners;
  }

  /// Pixels between the samples that are known; 0: none are, 1: the frame is complete.
  [[nodiscard]] int Step() const { return Known; }

  /// The pixels known so far; all others show nothing, and none has a colour before all are known.
  /// After an abort some of the next pass are there.
  [[nodiscard]] const Frame& Get() const { return TheFrame; }
  /// Takes the frame away.
  [[nodiscard]] Frame Take() { return std::move(TheFrame); }
  /// A frame whose pixels show the known sample of their block of Step() x Step() pixels, its lower
  /// left one, in their colours; the pipeline's modules are left out.
  [[nodiscard]] Frame Preview() const;

private:
  bool AtOnce(const Progress& progress);
  bool Pass(int step, const Progress& progress);

  Scene TheScene;
  Camera TheCamera;
  Pipeline ThePipeline;
  SampleNeeds Needs;
  Buffer Corners; ///< that the frame keeps
  Frame TheFrame;
  FrameCounters Finished; ///< of the passes that were not aborted
  int Known = 0;
};
} // namespace pixelexact
