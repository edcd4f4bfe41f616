// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameCost.h"

#include <gtest/gtest.h>

#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kPixels = 1e6;
constexpr double kLimit = 0.066;
using Work = FrameCost::Work;

/// Makes a frame whose rays cost `each` second when traced together and twice that in passes; gives
/// the step that is shown in the end.
int Make(FrameCost& cost, double each, double limit = kLimit)
{
  int step = 0;
  double spent = 0.0;
  for (;;)
  {
    const Work work = cost.Next(kPixels, step, spent, limit);
    if (work == Work::Show || step == 1)
    {
      return step;
    }
    const int next = work == Work::Complete ? 1 : step == 0 ? 8 : step / 2;
    const double part = 1.0 / (next * next) - (step == 0 ? 0.0 : 1.0 / (step * step));
    const double seconds = part * kPixels * each * (step == 0 && next == 1 ? 1.0 : 2.0);
    cost.Learn(kPixels, step, next, seconds);
    spent += seconds;
    step = next;
  }
}
} // namespace

TEST(FrameCost, WhoCanWaitGetsTheFrameAtOnce)
{
  const FrameCost cost;
  const double forever = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cost.Next(kPixels, 0, 0.0, forever), Work::Complete);
  EXPECT_EQ(cost.Next(kPixels, 4, 0.0, forever), Work::Complete);
}

TEST(FrameCost, ACostlyFirstFrameIsForgotten)
{
  FrameCost cost;
  // A first frame makes what later ones keep: here 10 times of what they cost.
  cost.Learn(kPixels, 0, 1, 0.3);
  // Their passes show it, and are left at once.
  EXPECT_EQ(Make(cost, 30e-9), 1);
  EXPECT_EQ(cost.Next(kPixels, 0, 0.0, kLimit), Work::Complete);
}

TEST(FrameCost, FramesThatAreCompleteAgainAreLearnedFrom)
{
  FrameCost cost;
  cost.Learn(kPixels, 0, 1, 0.03);
  EXPECT_EQ(cost.Next(kPixels, 0, 0.0, kLimit), Work::Complete);
  // Somebody moves closer: one frame is late, the next ones are not.
  EXPECT_EQ(Make(cost, 300e-9), 1);
  EXPECT_EQ(cost.Next(kPixels, 0, 0.0, kLimit), Work::Refine);
  EXPECT_GT(Make(cost, 300e-9), 1);
  // And back.
  EXPECT_EQ(Make(cost, 30e-9), 1);
}

TEST(FrameCost, CoarseFramesKeepToTheirTime)
{
  for (const double each : { 100e-9, 300e-9, 1e-6 })
  {
    FrameCost cost;
    cost.Learn(kPixels, 0, 1, kPixels * each);
    const int step = Make(cost, each);
    ASSERT_GT(step, 1);
    // Passes cost twice what was expected.
    EXPECT_LE(kPixels * 2.0 * each / (step * step), kLimit);
  }
  // What is there is refined by each further picture, however slow that is.
  FrameCost slow;
  slow.Learn(kPixels, 0, 1, 100.0);
  for (const int step : { 0, 8, 4, 2 })
  {
    EXPECT_EQ(slow.Next(kPixels, step, 0.0, kLimit), Work::Refine);
  }
  EXPECT_EQ(slow.Next(kPixels, 8, 1.0, kLimit), Work::Show);
}
} // namespace pixelexact
