// SPDX-License-Identifier: BSD-3-Clause
// Segments that meet a curved mesh, and segments beside it.
#include "CurvedMeshes.h"

#include "Core/Location/Sample.h"
#include "Core/Questions/MeshMiss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pixelexact::testing
{
namespace
{
Vec3 AnyWay(Random& random)
{
  return { random(), random(), random() };
}
} // namespace

TEST(MeshMiss, NoSegmentThatMeetsAnElementMisses)
{
  Random random(51);
  const CurvedMesh curved = Blocks(2, kShapes);
  const Mesh mesh = curved.View();
  const ElementIndex index(mesh);
  for (int k = 0; k < 1500; ++k)
  {
    const int element = static_cast<int>(random(0.0, mesh.Elements()));
    // A third of them at the boundary, where but an end touches.
    Vec3 xi = random.Inside(mesh.ShapeOf(element));
    if (k % 3 == 0)
    {
      xi.z = -1.0;
    }
    Vec3 x;
    MapForward(mesh, element, { &xi, 1 }, { &x, 1 });
    const double length = std::exp2(random(-20.0, 0.0));
    const Vec3 way = length * AnyWay(random);
    const Segment through{ x - random(0.0, 1.0) * way, x + way };
    EXPECT_FALSE(MissesMesh(index, through))
      << element << " at " << x.x << " " << x.y << " " << x.z;
    EXPECT_FALSE(MissesMesh(index, { x, x + way }));
  }
}

TEST(MeshMiss, SegmentsBesideTheMeshMiss)
{
  Random random(52);
  const CurvedMesh curved = Blocks(2, kShapes);
  const ElementIndex index(curved.View());
  int missed = 0;
  constexpr int kSegments = 2000;
  for (int k = 0; k < kSegments; ++k)
  {
    // The bent cube's own surroundings, within most of which lie the elements' boxes.
    LongVec3 u{ random(-1.1, 1.1), random(-1.1, 1.1), random(-1.1, 1.1) };
    u[static_cast<std::size_t>(k % 3)] = k % 2 == 0 ? random(1.02, 1.15) : random(-1.15, -1.02);
    const Vec3 from = ToDouble(Bend(u));
    missed += MissesMesh(index, { from, from + 0.003 * AnyWay(random) }) ? 1 : 0;
  }
  EXPECT_EQ(missed, kSegments);
}

TEST(MeshMiss, LittleEffortIsEnough)
{
  for (const Shape shape : kShapes)
  {
    Random random(53);
    const CurvedMesh curved = Blocks(1, std::span(&shape, 1));
    const ElementIndex index(curved.View());
    int missed = 0;
    constexpr int kSegments = 500;
    for (int k = 0; k < kSegments; ++k)
    {
      LongVec3 u{ random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0) };
      u[static_cast<std::size_t>(k % 3)] = k % 2 == 0 ? 1.02 : -1.02;
      const Vec3 from = ToDouble(Bend(u));
      missed += MissesMesh(index, { from, from + 0.003 * AnyWay(random) }, 40) ? 1 : 0;
    }
    EXPECT_EQ(missed, kSegments) << Name(shape);
  }
}

TEST(MeshMiss, SlackIsHonoured)
{
  const CurvedMesh curved = Blocks(1, std::span(kShapes).first(1));
  const ElementIndex index(curved.View());
  const Vec3 from = ToDouble(Bend({ 0.3L, -0.2L, 1.05L }));
  Segment segment{ from, from + Vec3(0.001, 0.002, 0.0) };
  EXPECT_TRUE(MissesMesh(index, segment));
  segment.slack = 0.1;
  EXPECT_FALSE(MissesMesh(index, segment));
}

/// Every map within the mesh's uncertainty is covered.
TEST(MeshMiss, UncertaintyIsHonoured)
{
  for (const double uncertainty : { 0.0, 0.01 })
  {
    MeshBuilder builder;
    builder.Add(UniformSpace(Shape::Hexahedron, 2), [](const LongVec3& xi) { return xi; });
    builder.Uncertainty[0] = uncertainty;
    const ElementIndex index(builder.View());
    EXPECT_EQ(MissesMesh(index, { { 0.1, 0.2, 1.005 }, { 0.3, 0.1, 1.005 } }), uncertainty == 0.0);
    EXPECT_TRUE(MissesMesh(index, { { 0.1, 0.2, 1.02 }, { 0.3, 0.1, 1.02 } }));
  }
}

TEST(MeshMiss, SaysNothingOfWhatIsNotFinite)
{
  const CurvedMesh curved = Blocks(1, std::span(kShapes).first(1));
  const ElementIndex index(curved.View());
  const Vec3 far(50.0);
  EXPECT_TRUE(MissesMesh(index, { far, far }));
  EXPECT_FALSE(MissesMesh(index, { far, Vec3(std::nan("")) }));
  EXPECT_FALSE(MissesMesh(index, { far, Vec3(std::numeric_limits<double>::infinity()) }));
}
} // namespace pixelexact::testing
