// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameCost.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// The part of a frame's pixels that is known.
double Part(int step)
{
  return step == 0 ? 0.0 : 1.0 / (static_cast<double>(step) * step);
}
} // namespace

FrameCost::Work FrameCost::Next(double pixels, int step, double spent, double limit) const
{
  const double left = (1.0 - Part(step)) * pixels * PixelSeconds;
  if (spent + left <= limit)
  {
    return Work::Complete;
  }
  // The next pass makes three pixels more of each that is known, and each costs what those that
  // were made just now did, or more.
  const double pass = 3.0 * std::max(Part(step) * pixels * PixelSeconds, spent);
  return spent <= 0.0 || (step > 1 && spent + pass <= limit) ? Work::Refine : Work::Show;
}

void FrameCost::Learn(double pixels, int from, int to, double seconds)
{
  const double each = seconds / ((Part(to) - Part(from)) * pixels);
  PixelSeconds = from == 0 && to == 1 ? each : std::min(PixelSeconds, each);
}
} // namespace pixelexact
