// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Triangles.h"

#include <glm/geometric.hpp>

#include <vector>

namespace pixelexact::testing
{
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
