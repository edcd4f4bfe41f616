// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/FrameTiles.h"
#include "Trace/Tracer.h"

#include <cstddef>
#include <utility>

namespace pixelexact
{
/// A frame that can be shown before it is complete. Passes trace coarse frames, then all pixels,
/// and then run the pipeline's modules. Progress functions or a deadline may end any pass; it
/// resumes at the first missing tile. The complete frame equals that of Trace, bit for bit, except
/// its counters' seconds, which sum up the passes.
///
/// A pass also traces pixels that earlier passes traced. Its rays are closer together, and the cost
/// per element is shared by all rays that meet it.
class ProgressiveFrame
{
public:
  /// Distance, in pixels, of the first pass's samples; each pass divides it by kFiner.
  static constexpr int kCoarsest = 16;
  static constexpr int kFiner = 4;

  /// The frame's centres get the pipeline's buffers and those of `extra`. The complete frame also
  /// keeps `corners` (KeepCorners). It reuses the memory of `spare`. Throws Error for a scene that
  /// cannot be traced. The objects of scene and pipeline must outlive this object.
  ProgressiveFrame(Scene scene, const Camera& camera, Pipeline pipeline,
    Buffer extra = Buffer::None, Buffer corners = Buffer::None, Frame spare = {});

  /// Sets the next pass to pixels `step` apart: 1, kFiner or kCoarsest, and less than Step() unless
  /// that is 0.
  void GoTo(int step);
  /// Runs or resumes the next pass. Returns false if `progress` or the deadline ended it. Completes
  /// at least one tile.
  bool Refine(const Progress& progress = {}, Deadline end = kNoDeadline);
  /// Runs all remaining passes; before the first pass, all pixels are traced at once, and nothing
  /// is kept if `progress` ends it. Returns false as Refine does.
  bool Complete(const Progress& progress = {});
  /// If no pass is complete, runs the coarsest one, and keeps the pass in progress.
  void Fill();

  /// Changes the colours of later passes. Their buffers of centres must be among the frame's.
  void Recolor(Pipeline pipeline, Buffer corners = Buffer::None);

  /// Count of the complete frame's pixels.
  [[nodiscard]] double Pixels() const
  {
    return static_cast<double>(camera_.Width()) * static_cast<double>(camera_.Height());
  }
  /// Distance of the known samples in pixels; 0: none are known, 1: all are.
  [[nodiscard]] int Step() const { return Known; }
  /// Distance of the next pass's samples; equal to Step() if all are known.
  [[nodiscard]] int NextStep() const { return Next; }
  /// The completed part of the next pass, 0 to 1.
  [[nodiscard]] double PartDone() const;
  [[nodiscard]] bool IsComplete() const { return Left == Stage::Nothing; }
  /// Sum of the time of all passes.
  [[nodiscard]] double Seconds() const { return Spent; }

  /// The frame. It has no colours before all pixels are known; then some tiles may have theirs.
  [[nodiscard]] const Frame& Get() const { return frame_; }
  /// Moves the frame out of the object.
  [[nodiscard]] Frame Take() { return std::move(frame_); }

  /// The known samples in colours, without the pipeline's modules: a frame of every Step()-th pixel
  /// of every Step()-th row, from the lower left. If no pass is complete, Get() with the colours of
  /// the known tiles.
  [[nodiscard]] Frame Preview() const;

private:
  enum class Stage
  {
    Centres,
    PixelCorners,
    Modules,
    Nothing
  };

  bool AtOnce(const Progress& progress);
  bool Pass(const Progress& progress, Deadline end);
  bool MakeCorners(const Progress& progress, Deadline end);
  bool RunModules(const Progress& progress, Deadline end);
  void BeginStage(Stage stage);
  /// An empty frame of pixels `step` apart.
  [[nodiscard]] Frame FrameOf(int step);

  Scene scene_;
  Camera camera_;
  Pipeline pipeline_;
  SampleNeeds Needs;
  Buffer Corners; ///< buffers of corners that the frame keeps
  Frame Spare;    ///< memory for the frame of all pixels
  Frame frame_;
  Frame Coarse;                ///< frame of step Known, if that is more than 1
  Frame Pending;               ///< frame of a coarse pass in progress
  Stage Left = Stage::Centres; ///< the first incomplete stage
  int Known = 0;
  int Next = kCoarsest;
  std::size_t Run = 0;   ///< of modules
  TilesDone Done;        ///< of the pass or run in progress; empty: there is none
  FrameCounters Counted; ///< of that pass, and of corners and modules
  double Spent = 0.0;
};
} // namespace pixelexact
