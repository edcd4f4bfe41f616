// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HitBatch.h"

#include "Core/MeshBuilder.h"
#include "Core/QuadReference.h"

#include "Core/Faces/FaceTable.h"
#include "Core/Index/ElementIndex.h"
#include "Core/Shape/ShapeFace.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/ElementFaces.h"
#include "Trace/Surfaces/IsoSurface.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>

// Hits of curved surfaces and what is common to their tests.
namespace pixelexact::testing
{
/// Rays of one kind: $PIXELEXACT_CURVED_RAYS, by default few enough for every run.
inline int CurvedRayCount(int usual)
{
  const char* asked = std::getenv("PIXELEXACT_CURVED_RAYS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : usual;
}

inline double Seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline Ray RayTo(const Vec3& origin, const Vec3& through)
{
  return { origin, glm::normalize(through - origin) };
}

/// A point of a direction that no other is more likely than.
inline Vec3 RandomDirection(Random& random)
{
  for (;;)
  {
    const Vec3 v(random(), random(), random());
    const double length = glm::length(v);
    if (length > 0.1 && length < 1.0)
    {
      return v / length;
    }
  }
}

/// A ray through a point, starting `away` before it.
inline Ray RayThroughPoint(Random& random, const Vec3& point, double away)
{
  const Vec3 direction = RandomDirection(random);
  return { point - away * direction, direction };
}

/// |Phi(xi) - (origin + t direction)| in the element's size, in 113 bits: the largest coordinate.
inline double ResidualQuad(const Mesh& mesh, const Ray& ray, double t, int element, const Vec3& xi)
{
  const auto phi = EvaluateQuad(mesh.map, element, { xi.x, xi.y, xi.z });
  const auto e = static_cast<std::size_t>(element);
  double largest = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const Quad x = Quad(ray.origin[d]) + Quad(t) * Quad(ray.direction[d]);
    const Quad off = phi[static_cast<std::size_t>(d)].value -
      (x - Quad(mesh.centre[3 * e + static_cast<std::size_t>(d)])) / Quad(mesh.size[e]);
    largest = std::max(largest, std::fabs(static_cast<double>(off)));
  }
  return largest;
}

/// All faces without a neighbour.
inline std::vector<ElementFace> BoundaryOf(const ElementIndex& index)
{
  const Mesh& mesh = index.GetMesh();
  const FaceTable table(index);
  std::vector<ElementFace> faces;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < static_cast<int>(FacesOf(mesh.ShapeOf(e)).size()); ++f)
    {
      if (table.KindOf(e, f) == FaceKind::Boundary)
      {
        faces.push_back({ e, f });
      }
    }
  }
  return faces;
}
} // namespace pixelexact::testing
