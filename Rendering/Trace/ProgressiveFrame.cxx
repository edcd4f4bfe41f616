// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/ProgressiveFrame.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pixelexact
{
namespace
{
SampleLattice LatticeOf(int step)
{
  return { .step = step, .packed = step > 1 };
}

/// Adds the seconds of its lifetime.
class Clock
{
public:
  explicit Clock(double& seconds)
    : Seconds(seconds)
  {
  }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  ~Clock()
  {
    Seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - Start).count();
  }

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

bool AllDone(const TilesDone& tiles)
{
  return std::ranges::find(tiles, 0) == tiles.end();
}
} // namespace

ProgressiveFrame::ProgressiveFrame(
  Scene scene, const Camera& camera, Pipeline pipeline, Buffer extra, Buffer corners, Frame spare)
  : scene_(std::move(scene))
  , camera_(camera)
  , pipeline_(std::move(pipeline))
  , Needs(pipeline_.Needs())
  , Corners(corners)
  , Spare(std::move(spare))
{
  Needs.centres = Needs.centres | extra;
  RequireTraceable(scene_, Needs);
}

Frame ProgressiveFrame::FrameOf(int step)
{
  Frame frame = step == 1 ? std::move(Spare) : Frame{};
  frame.counters = {};
  frame.corners = {};
  frame.color.clear();
  frame.width = (camera_.Width() + step - 1) / step;
  frame.height = (camera_.Height() + step - 1) / step;
  frame.centres.Allocate(Needs.centres, frame.width, frame.height);
  return frame;
}

void ProgressiveFrame::GoTo(int step)
{
  if (Next != step)
  {
    Next = step;
    Done.clear();
  }
}

bool ProgressiveFrame::Refine(const Progress& progress, Deadline end)
{
  bool done = false;
  {
    const Clock clock(Spent);
    done = (Left != Stage::Centres || Pass(progress, end)) &&
      (Left != Stage::PixelCorners || MakeCorners(progress, end)) &&
      (Left != Stage::Modules || RunModules(progress, end));
  }
  frame_.counters.seconds = Coarse.counters.seconds = Spent;
  return done;
}

bool ProgressiveFrame::Complete(const Progress& progress)
{
  if (Known == 0 && Done.empty())
  {
    return AtOnce(progress);
  }
  if (Left == Stage::Centres)
  {
    GoTo(1);
  }
  return Refine(progress);
}

bool ProgressiveFrame::AtOnce(const Progress& progress)
{
  bool aborted = false;
  frame_ = Trace(
    scene_, camera_, pipeline_, { .centres = Needs.centres, .corners = Corners },
    [&](double done)
    {
      aborted = progress && !progress(done);
      return !aborted;
    },
    nullptr, std::move(Spare));
  Spent += frame_.counters.seconds;
  frame_.counters.seconds = Spent;
  if (aborted)
  {
    // Corners of some tiles are discarded.
    frame_.corners = {};
    frame_.color.clear();
    frame_.centres.color.clear();
    for (SampleBuffers& sheet : frame_.centres.behind)
    {
      sheet.color.clear();
    }
    return false;
  }
  Known = Next = 1;
  BeginStage(Stage::Nothing);
  return true;
}

bool ProgressiveFrame::Pass(const Progress& progress, Deadline end)
{
  Frame& frame = Next == 1 ? frame_ : Pending;
  const SampleLattice lattice = LatticeOf(Next);
  const int tiles = TilesOf(lattice, camera_.Width(), camera_.Height());
  if (Done.empty())
  {
    frame = FrameOf(Next);
    Done.assign(static_cast<std::size_t>(tiles), 0);
    Counted = {};
  }
  Reporter reporter(progress, tiles, end);
  Sheets sheets(frame.centres, Needs.centres);
  AddCounters(
    TraceLattice(scene_, camera_, lattice, sheets, reporter, nullptr, { .done = &Done }), Counted);
  if (!AllDone(Done))
  {
    return false;
  }
  // Omitted tiles have been counted as Nothing.
  Counted.nothing =
    static_cast<std::int64_t>(frame.centres.Size()) - Counted.exact - Counted.unknown;
  frame.counters = Counted;
  if (Next > 1)
  {
    Coarse = std::move(Pending);
  }
  Known = Next;
  Next = std::max(1, Known / kFiner);
  BeginStage(Known == 1 ? Stage::PixelCorners : Stage::Centres);
  return true;
}

void ProgressiveFrame::Fill()
{
  if (Known != 0)
  {
    return;
  }
  {
    const Clock clock(Spent);
    Coarse = FrameOf(kCoarsest);
    const Progress none;
    Reporter reporter(none, 1);
    Sheets sheets(Coarse.centres, Needs.centres);
    Coarse.counters =
      TraceLattice(scene_, camera_, LatticeOf(kCoarsest), sheets, reporter, nullptr);
  }
  Coarse.counters.seconds = Spent;
  Known = kCoarsest;
  if (Next == kCoarsest)
  {
    GoTo(kCoarsest / kFiner);
  }
}

void ProgressiveFrame::BeginStage(Stage stage)
{
  Left = stage;
  Done.clear();
  Counted = {};
  Run = 0;
}

bool ProgressiveFrame::MakeCorners(const Progress& progress, Deadline end)
{
  if (Corners != Buffer::None && !(Done.empty() && frame_.corners.Holds(Corners)))
  {
    const int tiles = TilesOf(kCorners, frame_.width + 1, frame_.height + 1);
    if (Done.empty())
    {
      Done.assign(static_cast<std::size_t>(tiles), 0);
      frame_.corners.Allocate(Corners, frame_.width + 1, frame_.height + 1);
    }
    Reporter reporter(progress, tiles, end);
    Sheets sheets(frame_.corners, Corners);
    AddSamples(
      TraceLattice(scene_, camera_, kCorners, sheets, reporter, nullptr, { .done = &Done }),
      frame_.counters);
    if (!AllDone(Done))
    {
      return false;
    }
  }
  BeginStage(Stage::Modules);
  return true;
}

bool ProgressiveFrame::RunModules(const Progress& progress, Deadline end)
{
  const int tiles = TilesOf(LatticeOf(1), frame_.width, frame_.height);
  while (Run < pipeline_.Runs().size())
  {
    if (Done.empty())
    {
      if (Run == 0)
      {
        BeginPipeline(pipeline_, frame_);
      }
      Done.assign(static_cast<std::size_t>(tiles), 0);
    }
    Reporter reporter(progress, tiles, end);
    AddSamples(RunPipelinePart(scene_, camera_, pipeline_, Run, frame_, reporter, Done), Counted);
    if (!AllDone(Done))
    {
      return false;
    }
    Done.clear();
    ++Run;
  }
  AddSamples(Counted, frame_.counters);
  BeginStage(Stage::Nothing);
  return true;
}

void ProgressiveFrame::Recolor(Pipeline pipeline, Buffer corners)
{
  pipeline_ = std::move(pipeline);
  Corners = corners;
  if (Left == Stage::Centres)
  {
    return;
  }
  if (Left == Stage::PixelCorners && !Done.empty())
  {
    frame_.corners = {};
  }
  BeginStage(Stage::PixelCorners);
}

double ProgressiveFrame::PartDone() const
{
  return Done.empty()
    ? 0.0
    : static_cast<double>(std::ranges::count(Done, 1)) / static_cast<double>(Done.size());
}

Frame ProgressiveFrame::Preview() const
{
  Frame frame = Known > 1 ? Coarse : frame_;
  // Modules have changed only some tiles so far.
  frame.color.clear();
  Repaint({ .colors = pipeline_.colors, .modules = {} }, frame);
  return frame;
}
} // namespace pixelexact
