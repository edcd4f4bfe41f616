// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Index/EmbreeBvh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pixelexact::testing
{
namespace
{
constexpr double kFar = std::numeric_limits<double>::max();

/// Many small boxes, some without extent, around a point.
std::vector<Box3> MakeRandomBoxes(Random& random, const Vec3& around, double size)
{
  const auto vector = [&](double most)
  { return most * Vec3(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0)); };
  std::vector<Box3> boxes;
  for (int i = 0; i < 400; ++i)
  {
    const Vec3 at = around + vector(size);
    const Vec3 half = glm::abs(vector(i % 5 == 0 ? 0.0 : 0.1 * size));
    boxes.push_back({ at - half, at + half });
  }
  return boxes;
}

Box3 BoundsOf(const std::vector<Box3>& boxes)
{
  Box3 bounds = boxes[0];
  for (const Box3& box : boxes)
  {
    bounds = { glm::min(bounds.lower, box.lower), glm::max(bounds.upper, box.upper) };
  }
  return bounds;
}

/// A lower bound of the distance by which the line misses the box, in the largest coordinate;
/// negative where it intersects.
long double Gap(const Box3& box, const Vec3& origin, const Vec3& direction)
{
  long double from = 0.0L;
  long double to = std::numeric_limits<long double>::infinity();
  for (int d = 0; d < 3; ++d)
  {
    const long double along = direction[d];
    const long double lower = static_cast<long double>(box.lower[d]) - origin[d];
    const long double upper = static_cast<long double>(box.upper[d]) - origin[d];
    if (along == 0.0L)
    {
      if (lower > 0.0L || upper < 0.0L)
      {
        return std::max(lower, -upper);
      }
      continue;
    }
    from = std::max(from, std::min(lower / along, upper / along));
    to = std::min(to, std::max(lower / along, upper / along));
  }
  return from - to;
}
} // namespace

TEST(Bvh, NoBoxAlongARayIsMissedAndFewOthersAreFound)
{
  Random random(3);
  std::vector<int> found;
  std::size_t met = 0;
  std::size_t extra = 0;
  for (const double size : { 1e-6, 1.0, 1e6 })
  {
    for (const double away : { 0.0, 10.0, 1e4 })
    {
      const Vec3 around(away * size, -2.0 * away * size, 0.5 * away * size);
      const std::vector<Box3> boxes = MakeRandomBoxes(random, around, size);
      const Box3 bounds = BoundsOf(boxes);
      const Bvh bvh(boxes, bounds);
      for (int i = 0; i < 400; ++i)
      {
        // Aims at a box, sometimes along an axis, from near and far.
        const Box3& at = boxes[static_cast<std::size_t>(i)];
        Vec3 direction(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
        direction[i % 3] *= i % 4 == 0 ? 0.0 : 1.0;
        direction = glm::normalize(direction);
        const double distance = size * (i % 7 == 0 ? 1e8 : random(0.0, 5.0));
        const Vec3 origin =
          (i % 2 == 0 ? at.lower : 0.5 * (at.lower + at.upper)) - distance * direction;
        const auto segment = ClipRay(bounds, origin, direction, 0.0, kFar);
        if (!segment)
        {
          continue;
        }
        bvh.QueryAlong(*segment, found);
        ASSERT_TRUE(std::ranges::is_sorted(found));
        ASSERT_EQ(std::ranges::adjacent_find(found), found.end());
        for (int k = 0; k < static_cast<int>(boxes.size()); ++k)
        {
          const bool listed = std::ranges::binary_search(found, k);
          if (Gap(boxes[static_cast<std::size_t>(k)], origin, direction) <= 0.0L)
          {
            ASSERT_TRUE(listed) << size << ", " << away << ", " << i << ", " << k;
            ++met;
          }
          else if (i % 7 != 0)
          {
            extra += listed ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(met, 5000U);
  // Boxes in the same leaf as an intersected one are also visited.
  EXPECT_LT(extra, met / 3);
}

TEST(ClipRay, WhatIsNotFiniteMeetsNothing)
{
  const Box3 box{ Vec3(-1.0), Vec3(1.0) };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(ClipRay(box, Vec3(0.0), { 1.0, 0.0, 0.0 }, 0.0, kFar));
  for (const double bad : { nan, infinity })
  {
    for (int d = 0; d < 3; ++d)
    {
      Vec3 x(0.0);
      x[d] = bad;
      EXPECT_FALSE(ClipRay(box, x, { 1.0, 0.0, 0.0 }, 0.0, kFar));
      EXPECT_FALSE(ClipRay(box, Vec3(0.0), x, 0.0, kFar));
    }
  }
}
} // namespace pixelexact::testing
