// SPDX-License-Identifier: BSD-3-Clause
// Where a field jumps across a value between two elements, in closed form.
#include "HitBatch.h"
#include "TwoBlocks.h"

#include "Core/Base/Error.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/IsoSurface.h"
#include "Trace/Surfaces/JumpWalls.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pixelexact::testing
{
namespace
{
TwoBlocks::Function Constant(double low, double high)
{
  return [=](int side, long double, long double) { return side == 0 ? low : high; };
}

/// y on one side, y + jump on the other.
TwoBlocks::Function MakeSlope(double jump)
{
  return [=](int side, long double y, long double) { return side == 0 ? y : y + jump; };
}

JumpWalls WallsOf(const TwoBlocks& blocks, int component, double value)
{
  return { *blocks.locator_, *blocks.Table, blocks.field_, component, value };
}

/// Checks that each ray along x has one hit where `isWall` is true.
template <class IsWall>
void ExpectWalls(const Surface& walls, int element, IsWall isWall)
{
  Random random(7);
  std::vector<Ray> rays;
  for (int i = 0; i < 400; ++i)
  {
    rays.push_back(TwoBlocks::RayAt(random(-1.1, 1.1), random(-1.1, 1.1)));
  }
  const auto all = MeetPoints(walls, rays);
  int met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const double y = rays[i].origin.y;
    const double z = rays[i].origin.z;
    const bool expected = std::fabs(y) < 1.0 && std::fabs(z) < 1.0 && isWall(y, z);
    ASSERT_EQ(all[i].size(), expected ? 1U : 0U) << y << ' ' << z;
    if (expected)
    {
      EXPECT_NEAR(all[i][0].t, 3.0 + static_cast<double>(TwoBlocks::Between(y, z)), 1e-14);
      EXPECT_EQ(all[i][0].status, HitStatus::Certain);
      EXPECT_EQ(all[i][0].point.element, element);
      ++met;
    }
  }
  EXPECT_GT(met, 20);
}
} // namespace

TEST(JumpWalls, ConstantsHaveOneBetween)
{
  const TwoBlocks blocks(1.0, { Constant(0.0, 1.0) });
  const JumpWalls walls = WallsOf(blocks, 0, 0.5);
  EXPECT_EQ(walls.Parts(), 1);
  ExpectWalls(walls, 0, [](double, double) { return true; });
  // The value itself is nowhere.
  EXPECT_THROW(IsoSurface(blocks.locator_->Index(), blocks.field_, 0, 0.5), Error);
  const IsoSurface none(blocks.locator_->Index(), blocks.field_, 0, 0.5, true);
  EXPECT_TRUE(HitsOf(none, TwoBlocks::RayAt(0.1, 0.2)).empty());
}

TEST(JumpWalls, ValuesBeyondBothSidesHaveNone)
{
  const TwoBlocks blocks(1.0, { Constant(0.0, 1.0) });
  for (const double value : { -0.5, 1.5 })
  {
    EXPECT_EQ(WallsOf(blocks, 0, value).Parts(), 0);
  }
  // One side has the value, which therefore is not between the two.
  EXPECT_TRUE(HitsOf(WallsOf(blocks, 0, 1.5), TwoBlocks::RayAt(0.1, 0.2)).empty());
}

TEST(JumpWalls, LinearFieldsHaveOneWhereTheValueLiesBetween)
{
  for (const bool swapped : { false, true })
  {
    const TwoBlocks blocks(1.0, { MakeSlope(1.0) }, swapped);
    const JumpWalls walls = WallsOf(blocks, 0, 0.25);
    EXPECT_EQ(walls.Parts(), 1);
    ExpectWalls(walls, 0, [](double y, double) { return y > -0.75 && y < 0.25; });
  }
}

TEST(JumpWalls, ContinuousFieldsHaveNone)
{
  const TwoBlocks blocks(1.0, { MakeSlope(0.0) });
  EXPECT_EQ(WallsOf(blocks, 0, 0.25).Parts(), 0);
}

TEST(JumpWalls, ComponentsAndMagnitudesHaveTheirOwn)
{
  const TwoBlocks blocks(1.0, { MakeSlope(0.0), Constant(0.0, 2.0) });
  EXPECT_EQ(WallsOf(blocks, 0, 0.25).Parts(), 0);
  ExpectWalls(WallsOf(blocks, 1, 1.0), 0, [](double, double) { return true; });
  // |(y, 0)| is below 0.5 where |y| is, |(y, 2)| nowhere.
  ExpectWalls(
    WallsOf(blocks, kMagnitude, 0.5), 0, [](double y, double) { return std::fabs(y) < 0.5; });
}

TEST(JumpWalls, OfFacesOfOtherSizesThereIsWhatBothHave)
{
  for (const bool swapped : { false, true })
  {
    const TwoBlocks blocks(0.5, { Constant(0.0, 1.0) }, swapped);
    ExpectWalls(WallsOf(blocks, 0, 0.5), 0,
      [](double y, double z) { return std::fabs(y) < 0.5 && std::fabs(z) < 0.5; });
  }
}

TEST(JumpWalls, MappedFieldsAreRefused)
{
  TwoBlocks blocks(1.0, { Constant(0.0, 1.0) });
  blocks.field_.mapping = Mapping::Density;
  EXPECT_THROW(WallsOf(blocks, 0, 0.5), Unsupported);
}
} // namespace pixelexact::testing
