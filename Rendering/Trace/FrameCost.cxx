// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameCost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace pixelexact
{
namespace
{
constexpr std::array kSteps{ 1, ProgressiveFrame::kFiner, ProgressiveFrame::kCoarsest };

/// Nothing has been traced yet.
bool IsFresh(const ProgressiveFrame& passes)
{
  return passes.Step() == 0 && passes.PartDone() == 0.0;
}

void TraceAll(ProgressiveFrame& passes, FrameCost& cost, const Progress& progress)
{
  const bool fresh = IsFresh(passes);
  if (passes.Complete(progress) && fresh)
  {
    cost.Learn(passes.Pixels(), 1, 1.0, passes.Seconds());
  }
}

void TraceUntil(ProgressiveFrame& passes, FrameCost& cost, Deadline end, const Progress& progress)
{
  bool aborted = false;
  const Progress watched = [&](double done)
  {
    aborted = aborted || (progress && !progress(done));
    return !aborted;
  };
  bool goesOn = true;
  while (goesOn && !passes.IsComplete())
  {
    const int step = passes.NextStep();
    const bool tracing = passes.Step() != 1;
    const double partBefore = passes.PartDone();
    const double before = passes.Seconds();
    const bool done = passes.Refine(watched, end);
    const double part = (passes.Step() == step ? 1.0 : passes.PartDone()) - partBefore;
    if (tracing && part > 0.0)
    {
      cost.Learn(passes.Pixels(), step, part, passes.Seconds() - before);
    }
    goesOn = done && !aborted && std::chrono::steady_clock::now() < end;
  }
  // A picture must not have missing tiles.
  passes.Fill();
}
} // namespace

int FrameCost::First(double pixels, double limit) const
{
  for (std::size_t pass = 0; pass < kSteps.size(); ++pass)
  {
    if (pixels * Each[pass] <= limit)
    {
      return kSteps[pass];
    }
  }
  return kSteps.back();
}

void FrameCost::Learn(double pixels, int step, double part, double seconds)
{
  const auto at = static_cast<std::size_t>(std::ranges::find(kSteps, step) - kSteps.begin());
  Each[at] = seconds / (part * pixels);
  double most = Each[at];
  for (std::size_t finer = at; finer > 0; --finer)
  {
    most *= kFewer;
    Each[finer - 1] = std::clamp(Each[finer - 1], Each[at], most);
  }
  double least = Each[at];
  for (std::size_t coarser = at + 1; coarser < Each.size(); ++coarser)
  {
    least /= kFewer;
    Each[coarser] = std::clamp(Each[coarser], least, Each[at]);
  }
}

void TracePasses(
  ProgressiveFrame& passes, FrameCost& cost, double seconds, const Progress& progress)
{
  if (std::isinf(seconds))
  {
    TraceAll(passes, cost, progress);
    return;
  }
  if (IsFresh(passes))
  {
    passes.GoTo(cost.First(passes.Pixels(), seconds));
  }
  using Seconds = std::chrono::duration<double>;
  const Deadline end = std::chrono::steady_clock::now() +
    std::chrono::duration_cast<Deadline::duration>(Seconds(seconds));
  TraceUntil(passes, cost, end, progress);
}
} // namespace pixelexact
