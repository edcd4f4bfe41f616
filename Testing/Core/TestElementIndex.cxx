// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Location/Sample.h"

#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
/// n^3 cubes that fill [0, n]^3.
MeshBuilder Cubes(int n)
{
  MeshBuilder mesh;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Vec3 at = Vec3(i % n, i / n % n, i / n / n) + Vec3(0.5);
    mesh.Add(
      UniformSpace(Shape::Hexahedron, 1),
      [=](const LongVec3& xi) -> LongVec3 {
        return { at.x + xi[0] / 2, at.y + xi[1] / 2, at.z + xi[2] / 2 };
      },
      at, 0.5);
  }
  return mesh;
}

bool Meets(const Box3& a, const Box3& b)
{
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
    glm::all(glm::lessThanEqual(b.lower, a.upper));
}
} // namespace

TEST(ElementIndex, FindsEveryBoxThatARegionMeets)
{
  const MeshBuilder mesh = Cubes(6);
  const ElementIndex index(mesh.View());
  Random random(11);
  std::vector<int> found;
  std::size_t most = 0;
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 corner(random(-1.0, 7.0), random(-1.0, 7.0), random(-1.0, 7.0));
    const Box3 region{ corner, corner + Vec3(random(0.0, 2.0), random(0.0, 2.0), 0.0) };
    index.FindNear(region, found);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    for (int e = 0; e < index.GetMesh().Elements(); ++e)
    {
      if (Meets(index.ElementBox(e), region))
      {
        ASSERT_TRUE(std::ranges::binary_search(found, e)) << i;
      }
    }
    most = std::max(most, found.size());
  }
  // The index does not return all elements.
  EXPECT_LT(most, 60U);
}

TEST(ElementIndex, TheLowestNumberOwnsASharedFace)
{
  const MeshBuilder mesh = Cubes(2);
  const Locator locator(mesh.View());
  // The point is on the face between elements 0 and 1.
  const Vec3 x(1.0, 0.4, 0.6);
  std::int32_t element = -1;
  SampleTarget target;
  target.element = std::span(&element, 1);
  SampleTile(locator, nullptr, std::span(&x, 1), target);
  EXPECT_EQ(element, 0);
}
} // namespace pixelexact::testing
