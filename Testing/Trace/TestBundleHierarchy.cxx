// SPDX-License-Identifier: BSD-3-Clause
// Bundles of rays against boxes: all that one of the rays meets are told, and each once.
#include "RayCheck.h"

#include "Trace/Surfaces/Curved/BundleHierarchy.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

namespace pixelexact::testing
{
namespace
{
constexpr int kRays = 64;

/// Rays from about one point to about another.
struct Rays
{
  std::array<std::array<double, kRays + kLanePadding>, 8> columns{};

  Rays(RandomRays& random, const Vec3& from, const Vec3& to, double spread)
  {
    columns[6].fill(kNearest);
    columns[7].fill(kFarthest);
    for (std::size_t i = 0; i < kRays; ++i)
    {
      const Vec3 origin = from + random.Vector(0.1 * spread);
      const Vec3 direction = glm::normalize(to + random.Vector(spread) - origin);
      for (std::size_t d = 0; d < 3; ++d)
      {
        columns[d][i] = origin[static_cast<int>(d)];
        columns[3 + d][i] = direction[static_cast<int>(d)];
      }
    }
  }
  [[nodiscard]] RayLanes View() const
  {
    const auto at = [this](std::size_t k) { return columns[k].data(); };
    return { { at(0), at(1), at(2) }, { at(3), at(4), at(5) }, at(6), at(7), kRays };
  }
};

std::vector<Box3> SomeBoxes(RandomRays& random, std::size_t count)
{
  std::vector<Box3> boxes;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vec3 middle = random.Vector(1.0);
    const Vec3 half = glm::abs(random.Vector(random.Size(-3.0, -0.5)));
    boxes.push_back({ middle - half, middle + half });
  }
  return boxes;
}

template <class Visit>
void ForEachBundle(std::uint64_t seed, int bundles, const Visit& visit)
{
  RandomRays random(seed);
  RayBundle bundle;
  for (int k = 0; k < bundles; ++k)
  {
    const auto count = static_cast<std::size_t>(random.Size(0.0, 3.0));
    const std::vector<Box3> boxes = SomeBoxes(random, count);
    const Rays rays(
      random, random.Vector(random.Size(-1.0, 2.0)), random.Vector(1.0), random.Size(-3.0, 0.0));
    const RayLanes lanes = rays.View();
    const BundleHierarchy hierarchy(boxes);
    for (unsigned ways = GetBundleKernels().ways(lanes, 0, kRays); ways != 0; ways &= ways - 1)
    {
      bundle.Begin(lanes, 0, kRays, std::countr_zero(ways), hierarchy.Bounds());
      visit(bundle, hierarchy, boxes);
    }
  }
}
} // namespace

TEST(BundleHierarchy, TellsEachBoxThatARayMeetsOnce)
{
  std::size_t met = 0;
  ForEachBundle(11, 3000,
    [&](const RayBundle& bundle, const BundleHierarchy& hierarchy, const std::vector<Box3>& boxes)
    {
      std::vector<int> told(boxes.size(), 0);
      hierarchy.ForEach(bundle,
        [&](int k, const Box3& box)
        {
          const auto at = static_cast<std::size_t>(k);
          ++told[at];
          EXPECT_EQ(box.lower, boxes[at].lower);
          EXPECT_EQ(box.upper, boxes[at].upper);
        });
      for (std::size_t k = 0; k < boxes.size(); ++k)
      {
        const bool isMet =
          !GetPieceKernels().meetBox(bundle, boxes[k], RaySet::First(kRays)).IsEmpty();
        EXPECT_LE(told[k], 1);
        EXPECT_TRUE(!isMet || told[k] == 1);
        EXPECT_EQ(told[k] == 1, bundle.MayMeet(boxes[k]));
        met += isMet ? 1 : 0;
      }
    });
  EXPECT_GT(met, 5000U);
}

TEST(BundleHierarchy, LeavesOutWhatLiesBehindAllRays)
{
  RandomRays random(12);
  ForEachBundle(13, 200,
    [&](RayBundle& bundle, const BundleHierarchy& hierarchy, const std::vector<Box3>& boxes)
    {
      const double depth = random.Size(-2.0, 1.0);
      for (int i = 0; i < kRays; ++i)
      {
        bundle.EndAt(i, depth);
      }
      bundle.FindFarthest();
      std::vector<int> told(boxes.size(), 0);
      hierarchy.ForEach(
        bundle, [&](int k, const Box3& /*box*/) { ++told[static_cast<std::size_t>(k)]; });
      for (std::size_t k = 0; k < boxes.size(); ++k)
      {
        EXPECT_EQ(told[k] == 1,
          bundle.MayMeet(boxes[k]) && !(bundle.DepthOf(boxes[k]) > bundle.Farthest()));
      }
    });
}

TEST(BundleHierarchy, EightBoxesAreToldAsOne)
{
  ForEachBundle(14, 300,
    [](
      const RayBundle& bundle, const BundleHierarchy& /*hierarchy*/, const std::vector<Box3>& boxes)
    {
      EightBoxes eight;
      eight.count = static_cast<int>(std::min(boxes.size(), EightBoxes::kMax));
      for (std::size_t k = 0; k < static_cast<std::size_t>(eight.count); ++k)
      {
        eight.Set(k, boxes[k]);
      }
      std::array<double, EightBoxes::kMax> depth{};
      const unsigned met = bundle.MayMeet(eight, depth);
      EXPECT_EQ(met >> static_cast<unsigned>(eight.count), 0U);
      for (std::size_t k = 0; k < static_cast<std::size_t>(eight.count); ++k)
      {
        EXPECT_EQ((met >> k & 1U) != 0, bundle.MayMeet(boxes[k]));
        EXPECT_EQ(depth[k], bundle.DepthOf(boxes[k]));
      }
    });
}
} // namespace pixelexact::testing
