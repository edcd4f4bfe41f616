// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/FrameTiles.h"
#include "Trace/Tracer.h"

#include <cstddef>
#include <utility>

namespace pixelexact
{
/// A frame that can be looked at before it is done: small frames of pixels far apart first, then
/// all pixels, at last what the pipeline's modules make of them. Any of these passes may be ended,
/// by progress functions or a deadline, and goes on tile by tile where it was. The complete frame
/// is that of Trace, bit for bit, but for its counters' seconds, which are the sum of the passes'.
///
/// A pass traces the pixels again that are known: it has rays closer together for that, and what
/// elements cost is shared by all that meet them.
class ProgressiveFrame
{
public:
  /// Pixels between the samples of the first pass; each pass divides it by kFiner.
  static constexpr int kCoarsest = 16;
  static constexpr int kFiner = 4;

  /// Makes the pipeline's buffers of centres and those of `extra`; the complete frame has
  /// `corners`, too (KeepCorners); it is made in the memory of `spare`, which nobody needs any
  /// more. Throws Error for a scene that cannot be traced. What scene and pipeline refer to must
  /// outlive this.
  ProgressiveFrame(Scene scene, const Camera& camera, Pipeline pipeline,
    Buffer extra = Buffer::None, Buffer corners = Buffer::None, Frame spare = {});

  /// The next pass is that of pixels `step` apart: 1, kFiner or kCoarsest, less than Step() where
  /// that is not 0.
  void GoTo(int step);
  /// The next pass, or what is left of it. False where `progress` or the time ended it. At least a
  /// tile is made.
  bool Refine(const Progress& progress = {}, Deadline end = kNoDeadline);
  /// All that is left, in one pass if there was none yet; what such a one has made is lost where
  /// `progress` ends it. False as Refine.
  bool Complete(const Progress& progress = {});
  /// Where no pass is done yet: the coarsest, beside the one that was begun.
  void Fill();

  /// From now on in other colours; their buffers of centres must be among those that are made.
  void Recolor(Pipeline pipeline, Buffer corners = Buffer::None);

  /// Of the complete frame.
  [[nodiscard]] double Pixels() const
  {
    return static_cast<double>(camera_.Width()) * static_cast<double>(camera_.Height());
  }
  /// Pixels between the samples that are known; 0: none are, 1: all are.
  [[nodiscard]] int Step() const { return Known; }
  /// Those of the next pass; the same as Step() where all are known.
  [[nodiscard]] int NextStep() const { return Next; }
  /// The part of the next pass that is done.
  [[nodiscard]] double PartDone() const;
  [[nodiscard]] bool IsComplete() const { return Left == Stage::Nothing; }
  /// That all passes took.
  [[nodiscard]] double Seconds() const { return Spent; }

  /// The frame, without colours before all pixels are known. Before that those of some tiles may be
  /// there.
  [[nodiscard]] const Frame& Get() const { return frame_; }
  /// Takes the frame away.
  [[nodiscard]] Frame Take() { return std::move(frame_); }

  /// What is known, in colours, without the pipeline's modules: a frame of every Step()-th pixel of
  /// every Step()-th row, from the lower left one on. Where no pass is done, Get() with the colours
  /// of what is there.
  [[nodiscard]] Frame Preview() const;

private:
  enum class Stage
  {
    Centres,
    Corners,
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
  Buffer Corners; ///< that the frame keeps
  Frame Spare;    ///< for the frame of all pixels
  Frame frame_;
  Frame Coarse;                ///< of Known, where that is more than 1
  Frame Pending;               ///< of a coarse pass that was begun
  Stage Left = Stage::Centres; ///< the first thing that is not done
  int Known = 0;
  int Next = kCoarsest;
  std::size_t Run = 0;   ///< of modules
  TilesDone Done;        ///< of the pass or run that was begun; empty: none was
  FrameCounters Counted; ///< of that pass, and of corners and modules
  double Spent = 0.0;
};
} // namespace pixelexact
