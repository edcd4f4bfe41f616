// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <memory>
#include <vector>

// Balls and cubes, as triangles and as parts of a combination.
namespace pixelexact::testing
{
/// The part in a ball.
inline Combined::Part MakeBallPart(const Vec3& centre, double radius)
{
  return { std::make_shared<Quadric>(MakeSphere(centre, radius)),
    [=](const Vec3& x) { return glm::dot(x - centre, x - centre) - radius * radius; } };
}

/// The part in the cube [-half, half]^3.
inline Combined::Part MakeCubePart(double half)
{
  return { std::make_shared<ConvexBody>(MakeBox(Vec3(-half), Vec3(half))),
    [=](const Vec3& x)
    {
      const Vec3 size = glm::abs(x);
      return std::max({ size.x, size.y, size.z }) - half;
    } };
}

/// An octahedron about a centre whose faces are cut in four `level` times, with all corners on the
/// sphere: convex, and shared to the bit.
inline std::vector<Triangles::Triangle> Ball(
  int level, const Vec3& centre = Vec3(0.0), double radius = 1.0)
{
  std::vector<Triangles::Triangle> faces;
  for (int k = 0; k < 8; ++k)
  {
    const Vec3 x((k & 1) != 0 ? 1.0 : -1.0, 0.0, 0.0);
    const Vec3 y(0.0, (k & 2) != 0 ? 1.0 : -1.0, 0.0);
    const Vec3 z(0.0, 0.0, (k & 4) != 0 ? 1.0 : -1.0);
    faces.push_back({ x, y, z });
  }
  const auto middle = [](const Vec3& a, const Vec3& b)
  {
    // Commutative, so that neighbours get the same.
    return glm::normalize(a + b);
  };
  for (int i = 0; i < level; ++i)
  {
    std::vector<Triangles::Triangle> finer;
    for (const auto& [a, b, c] : faces)
    {
      const Vec3 ab = middle(a, b);
      const Vec3 bc = middle(b, c);
      const Vec3 ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    faces = finer;
  }
  for (Triangles::Triangle& face : faces)
  {
    for (Vec3& x : face)
    {
      x = centre + radius * x;
    }
  }
  return faces;
}
} // namespace pixelexact::testing
