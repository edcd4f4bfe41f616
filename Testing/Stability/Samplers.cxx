// SPDX-License-Identifier: BSD-3-Clause
#include "Stability/Samplers.h"

#include "Core/Shape/Shape.h"

#include <glm/common.hpp>

namespace pixelexact::testing
{
Vec3 AnywhereInside(Shape shape, Random& random)
{
  for (;;)
  {
    Vec3 eta(random(), random(), random());
    // Half of the points in the volume, the others on faces, edges and vertices.
    const int bounds = static_cast<int>(std::max(0.0, random(-3.0, 4.0)));
    for (int d = 0; d < bounds; ++d)
    {
      const int direction = static_cast<int>(random(0.0, 3.0));
      eta[direction] = random() < 0.0 ? -1.0 : 1.0;
    }
    const Vec3 xi = TensorToReference(shape, eta);
    if (Margin(shape, xi) >= 0.0)
    {
      return xi;
    }
  }
}

Vec3 BeyondAFace(Shape shape, double reach, Random& random)
{
  const int upperFaces = shape == Shape::Hexahedron ? 3 : (shape == Shape::Tetrahedron ? 1 : 2);
  Vec3 eta(random(), random(), random());
  const double distance = std::pow(10.0, random(-16.0, std::log10(reach)));
  const int face = static_cast<int>(random(0.0, 3.0 + upperFaces));
  eta[face % 3] = face < 3 ? -1.0 - distance : 1.0 + distance;
  return TensorToReference(shape, eta);
}

Vec3 NearCollapsed(Shape shape, double distance, Random& random)
{
  for (;;)
  {
    Vec3 eta(random(-1.2, 1.2), random(-1.2, 1.2), random());
    eta = glm::clamp(eta, Vec3(-1.0), Vec3(1.0));
    // Besides the vertex, tetrahedra have a collapsed edge.
    const bool vertex = shape != Shape::Tetrahedron || random() < 0.0;
    eta[vertex ? 2 : 1] = 1.0 - distance * random(0.5, 1.0);
    const Vec3 xi = TensorToReference(shape, eta);
    if (Margin(shape, xi) >= 0.0)
    {
      return xi;
    }
  }
}

Vec3 BeyondNearCollapsed(Shape shape, double distance, Random& random)
{
  for (;;)
  {
    const Vec3 step(random(), random(), random());
    const Vec3 xi = NearCollapsed(shape, distance, random) + std::min(distance, 0.2) * step;
    if (Margin(shape, xi) < 0.0)
    {
      return xi;
    }
  }
}
} // namespace pixelexact::testing
