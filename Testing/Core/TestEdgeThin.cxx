// SPDX-License-Identifier: BSD-3-Clause
// Bounds along edges in thin elements that bend, as of boundary layers.
#include "EdgeCases.h"

namespace pixelexact::testing
{
namespace
{
/// A part of a tube by the first terms of cosine and sine, to both sides by an angle: it bends
/// along xi_along, and is thin along the next.
LongVec3 TubeWall(const LongVec3& xi, std::size_t along, long double thickness, long double most)
{
  const long double angle = most * xi[along];
  const long double square = angle * angle;
  const long double radius = 1 + thickness / 2 * xi[(along + 1) % 3];
  return { radius * (1 - square / 2 + square * square / 24),
    radius * angle * (1 - square / 6 + square * square / 120), 0.7L * xi[(along + 2) % 3] };
}

struct ThinCase : RangeCase
{
  ThinCase(Shape shape, std::size_t along, long double thickness, long double most, Random& random)
    : RangeCase(
        UniformSpace(shape, 6),
        [=](const LongVec3& xi) { return TubeWall(xi, along, thickness, most); }, Vec3(0.0), 1.0)
    , locator(mesh)
  {
    SetNoise(3, random, 0.7);
    bounds = std::make_unique<EdgeBounds>(mesh, locator.Index().BoundsOf(0), 0, field, 0);
  }

  [[nodiscard]] LocatedPoint At(const Vec3& xi) const
  {
    LocatedPoint point;
    point.xi = xi;
    point.eta = ReferenceToTensor(mesh.ShapeOf(0), xi);
    MapForward(mesh, 0, { &xi, 1 }, { &point.x, 1 });
    EvaluateAt(mesh, field, 0, { &xi, 1 }, { &point.value, 1 }, {});
    return point;
  }

  Locator locator;
  std::unique_ptr<EdgeBounds> bounds;
};
} // namespace

/// However they are turned.
TEST(EdgeBounds, ThinBentElementsAreKnown)
{
  Random random(81);
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism })
  {
    for (const double thickness : { 0.1, 0.01 })
    {
      for (std::size_t along = 0; along < 3; ++along)
      {
        SCOPED_TRACE(::testing::Message()
          << Name(shape) << ", along " << along << ", thickness " << thickness);
        const double most = shape == Shape::Hexahedron ? 0.8 : 0.16;
        const ThinCase one(shape, along, thickness, most, random);
        for (int k = 0; k < 50; ++k)
        {
          const Vec3 xi = 0.9 * random.Inside(shape);
          const LocatedPoint a = one.At(xi);
          const LocatedPoint b = one.At(xi + 1e-4 * Direction(random));
          const auto range = one.bounds->Along(a, b);
          ASSERT_TRUE(range);
          EXPECT_LE(range->deviation, 1e-3 * one.bounds->Values().Magnitude());
        }
      }
    }
  }
}

/// Elements as thin as the first layers on walls: segments from side to side and to points outside,
/// and the values that they may take.
TEST(EdgeBounds, LayersAreKnownHoweverThin)
{
  Random random(82);
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism })
  {
    for (const double thickness : { 1e-3, 1e-5, 1e-7 })
    {
      for (std::size_t along = 0; along < 3; ++along)
      {
        SCOPED_TRACE(::testing::Message()
          << Name(shape) << ", along " << along << ", thickness " << thickness);
        const ThinCase one(shape, along, thickness, 0.8, random);
        const int across = static_cast<int>((along + 1) % 3);
        for (int k = 0; k < 20; ++k)
        {
          const Vec3 xi = 0.7 * random.Inside(shape);
          Vec3 through(0.0);
          through[across] = -0.01;
          const LocatedPoint a = one.At(xi);
          const LocatedPoint b = one.At(xi + through);
          const auto range = one.bounds->Along(a, b);
          ASSERT_TRUE(range);
          const LocatedPoint beside = one.At(xi + 1e-4 * std::sqrt(thickness) * Direction(random));
          EXPECT_TRUE(one.bounds->Along(a, beside));
          const Interval all = one.bounds->Values();
          const double other = a.value + 0.2 * (all.upper - all.lower);
          EXPECT_FALSE(one.bounds->MayTake(
            { std::span(&other, 1) }, { Outline(a.x, b.x), 0.0 }, { EdgeEffort::kAny, 0 }));
        }
      }
    }
  }
}
} // namespace pixelexact::testing
