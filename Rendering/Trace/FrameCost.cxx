// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameCost.h"

#include <algorithm>
#include <cstddef>

namespace pixelexact
{
namespace
{
constexpr std::array kSteps{ 1, ProgressiveFrame::kFiner, ProgressiveFrame::kCoarsest };
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
} // namespace pixelexact
