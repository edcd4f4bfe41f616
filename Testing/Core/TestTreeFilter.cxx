// SPDX-License-Identifier: BSD-3-Clause
// The filter before the inverse map: what it excludes, with and without a look at inner points.
#include "MeshBuilder.h"

#include "Core/Index/ElementIndex.h"
#include "Core/Location/PointBudget.h"
#include "Core/Location/PointKernels.h"
#include "Core/Location/TreeFilter.h"

#include <gtest/gtest.h>

#include <bit>

namespace pixelexact::testing
{
namespace
{
/// A map so curved that a local frame bounds it poorly.
LongVec3 Turned(const LongVec3& u)
{
  const auto [a, b, c] = u;
  return { a + 0.45L * b * b - 0.2L * a * c, b - 0.35L * a * a + 0.1L * b * c * a,
    c + 0.3L * a * b - 0.2L * b * b };
}

class FilterOf : public ::testing::TestWithParam<Shape>
{
};

TEST_P(FilterOf, InnerChunksAloneAreNotTested)
{
  const Shape shape = GetParam();
  MeshBuilder builder;
  builder.Add(UniformSpace(shape, 3), Turned, Vec3(0.0), 2.0);
  const Mesh mesh = builder.View();
  const ElementIndex index(mesh);
  const ElementBounds& bounds = index.BoundsOf(0);
  ASSERT_TRUE(TreeFilter::IsWorthIt(bounds));

  // Blocks of 8 x 8 points of planes, as in frames, in and near the element.
  constexpr int kChunks = 64;
  Random random(5);
  std::vector<double> lanes(3 * kChunks * kChunkPoints);
  double* const x[3] = { lanes.data(), lanes.data() + kChunks * kChunkPoints,
    lanes.data() + 2 * kChunks * kChunkPoints };
  for (int chunk = 0; chunk < kChunks; ++chunk)
  {
    const Vec3 xi = 1.2 * random.Inside(shape);
    const LongVec3 at = Turned({ xi.x, xi.y, xi.z });
    const Vec3 across(0.01 * random(), 0.01 * random(), 0.01 * random());
    const Vec3 up(0.01 * random(), 0.01 * random(), 0.01 * random());
    for (int k = 0; k < kChunkPoints; ++k)
    {
      for (int d = 0; d < 3; ++d)
      {
        x[d][chunk * kChunkPoints + k] = static_cast<double>(at[static_cast<std::size_t>(d)]) +
          (k % 8) * across[d] + static_cast<double>(k / 8) * up[d];
      }
    }
  }
  const LanePoints points{ { x[0], x[1], x[2] }, kChunks * kChunkPoints };
  std::vector<PointChunk> chunks;
  std::uint64_t near = 0;
  for (int chunk = 0; chunk < kChunks; ++chunk)
  {
    chunks.push_back(
      GetPointKernels().chunk(points, chunk * kChunkPoints, kChunkPoints, index.Bounds()));
    near |= chunks.back().open != 0 ? std::uint64_t{ 1 } << static_cast<unsigned>(chunk) : 0;
  }

  TreeFilter filter;
  std::array<std::uint64_t, kChunks> kept{};
  std::array<std::uint64_t, kChunks> quickly{};
  const auto tree = index.TreeOf(0);
  filter.Run(*tree, points, chunks, near, kept);
  const std::uint64_t inner = filter.RunButInner(*tree, bounds, points, chunks, near, quickly);
  EXPECT_EQ(inner & ~near, 0U);
  // Neither is empty.
  EXPECT_GE(std::popcount(inner), 4);
  EXPECT_GE(std::popcount(near & ~inner), 4);
  int wrong = 0;
  for (std::size_t k = 0; k < kChunks; ++k)
  {
    if ((near >> k & 1U) == 0)
    {
      continue;
    }
    const bool untested = (inner >> k & 1U) != 0;
    EXPECT_EQ(quickly[k], untested ? chunks[k].open : kept[k]) << k;
    wrong += untested && kept[k] != chunks[k].open ? 1 : 0;
  }
  // The filter is a heuristic; it must be right nearly always.
  EXPECT_LE(wrong, 1);
}

INSTANTIATE_TEST_SUITE_P(Shapes, FilterOf, ::testing::ValuesIn(kShapes));

TEST(PointBudget, ElementsTogetherTakeNoMoreThanAPointMay)
{
  for (int elements = 1; elements < 100; ++elements)
  {
    PointBudget budget(elements);
    std::int64_t most = elements * budget.Share();
    for (int k = 0; k < elements; ++k)
    {
      const std::int64_t more = budget.TakeMore();
      EXPECT_TRUE(more == 0 || more > budget.Share()) << elements;
      most += more;
    }
    EXPECT_LE(most, kMaxWork) << elements;
    EXPECT_GE(most, kMaxWork / 2 - elements) << elements;
  }
}
} // namespace
} // namespace pixelexact::testing
