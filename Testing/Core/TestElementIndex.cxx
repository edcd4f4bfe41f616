// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
/// n^3 cubes that fill [0, n]^3.
MeshBuilder Cubes(int n, double offset = 0.0)
{
  MeshBuilder mesh;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Vec3 at = Vec3(i % n, i / n % n, i / n / n) + Vec3(0.5 + offset);
    mesh.Add(
      UniformSpace(Shape::Hexahedron, 1),
      [=](const LongVec3& xi) -> LongVec3 {
        return { at.x + xi[0] / 2, at.y + xi[1] / 2, at.z + xi[2] / 2 };
      },
      at, 0.5);
  }
  return mesh;
}

bool Meets(const Box3& box, const Segment& segment)
{
  double from = 0.0;
  double to = 1.0;
  for (int d = 0; d < 3; ++d)
  {
    const double along = segment.to[d] - segment.from[d];
    const double a = (box.lower[d] - segment.from[d]) / along;
    const double b = (box.upper[d] - segment.from[d]) / along;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}
} // namespace

TEST(ElementIndex, FindsEveryBoxThatASegmentMeets)
{
  const MeshBuilder mesh = Cubes(6);
  const ElementIndex index(mesh.View());
  Random random(11);
  std::vector<int> found;
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Segment segment{ { random(-1.0, 7.0), random(-1.0, 7.0), random(-1.0, 7.0) },
      { random(-1.0, 7.0), random(-1.0, 7.0), random(-1.0, 7.0) } };
    index.FindAlong(std::span(&segment, 1), found);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    for (int e = 0; e < index.GetMesh().Elements(); ++e)
    {
      if (Meets(index.ElementBox(e), segment))
      {
        ASSERT_TRUE(std::ranges::binary_search(found, e)) << i;
      }
    }
    most = std::max(most, found.size());
  }
  // Not simply all of them.
  EXPECT_LT(most, 120U);
}

TEST(ElementIndex, ClipsRaysToTheMesh)
{
  const MeshBuilder mesh = Cubes(2);
  const ElementIndex index(mesh.View());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const auto segment = index.ClipRay({ -5.0, 0.3, 0.4 }, { 1.0, 0.0, 0.0 }, 0.0, kFar);
  ASSERT_TRUE(segment.has_value());
  EXPECT_NEAR(segment->from.x, 0.0, 1e-12);
  EXPECT_NEAR(segment->to.x, 2.0, 1e-12);
  EXPECT_LE(segment->from.x, 0.0);
  EXPECT_GE(segment->to.x, 2.0);
  EXPECT_FALSE(index.ClipRay({ -5.0, 0.3, 0.4 }, { -1.0, 0.0, 0.0 }, 0.0, kFar).has_value());
  EXPECT_FALSE(index.ClipRay({ -5.0, 3.3, 0.4 }, { 1.0, 0.0, 0.0 }, 0.0, kFar).has_value());
}

TEST(ElementIndex, RaysFromFarAwayMissNothing)
{
  // Its sides are no multiples of what doubles are apart where the rays begin.
  constexpr double kOffset = 1e-5;
  const MeshBuilder mesh = Cubes(4, kOffset);
  const ElementIndex index(mesh.View());
  Random random(13);
  std::vector<int> found;
  for (int i = 0; i < 300; ++i)
  {
    // Of a ray that ends by the mesh's edge. A double's spacing at its origin is 1e-4: where it
    // ends is known in long double alone.
    const Vec3 at(1e-4 * random(), 1e-4 * random(), random(0.2, 3.8));
    const Vec3 origin = at + 1e12 * Vec3(random(), random(), random());
    const Vec3 direction = (at - origin) / 3.0;
    const auto segment = index.ClipRay(origin, direction, 3.0, 3.0);
    for (int e = 0; e < index.GetMesh().Elements(); ++e)
    {
      const Box3& box = index.ElementBox(e);
      long double from = 3.0L;
      long double to = 3.0L;
      for (int d = 0; d < 3; ++d)
      {
        const long double a = (static_cast<long double>(box.lower[d]) - origin[d]) / direction[d];
        const long double b = (static_cast<long double>(box.upper[d]) - origin[d]) / direction[d];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
      }
      if (from <= to)
      {
        ASSERT_TRUE(segment.has_value()) << i;
        index.FindAlong(std::span(&*segment, 1), found);
        ASSERT_TRUE(std::ranges::binary_search(found, e)) << i << ", " << e;
      }
    }
  }
}

TEST(ElementIndex, ThePriorityDecidesWhoOwnsASharedFace)
{
  const MeshBuilder mesh = Cubes(2);
  Locator locator(mesh.View());
  // On the face between elements 0 and 1.
  const Vec3 x(1.0, 0.4, 0.6);
  std::int32_t element = -1;
  SampleTarget target;
  target.element = std::span(&element, 1);
  SampleTile(locator, nullptr, std::span(&x, 1), target);
  EXPECT_EQ(element, 0);
  const std::vector<std::int64_t> global{ 70, 10, 20, 30, 40, 50, 60, 80 };
  locator.Index().SetPriority(global);
  SampleTile(locator, nullptr, std::span(&x, 1), target);
  EXPECT_EQ(element, 1);
  EXPECT_THROW(locator.Index().SetPriority(std::span(global).first(3)), Error);
}
} // namespace pixelexact::testing
