// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ClosedSurface.h"
#include "MeshBuilder.h"

#include <gtest/gtest.h>

#include <ostream>

// Faces of made meshes, and what is expected of their tables.
namespace pixelexact::testing
{
struct Counts
{
  std::int64_t boundary = 0;
  std::int64_t interior = 0;
  std::int64_t hanging = 0;
  std::int64_t partly = 0;

  bool operator==(const Counts&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c)
  {
    return out << c.boundary << " boundary, " << c.interior << " interior, " << c.hanging
               << " hanging, " << c.partly << " partly";
  }
};

inline Counts CountsOf(const FaceTable& faces)
{
  return { faces.CountOf(FaceKind::Boundary), faces.CountOf(FaceKind::Interior),
    faces.CountOf(FaceKind::Hanging), faces.CountOf(FaceKind::Partly) };
}

/// Every interior face's neighbour has it as its own.
inline void ExpectNeighboursAgree(const Mesh& mesh, const FaceTable& faces)
{
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < static_cast<int>(FacesOf(mesh.ShapeOf(e)).size()); ++f)
    {
      const ElementFace other = faces.NeighbourOf(e, f);
      if (faces.KindOf(e, f) != FaceKind::Interior)
      {
        EXPECT_EQ(other.element, -1);
        continue;
      }
      ASSERT_GE(other.element, 0) << e << ' ' << f;
      EXPECT_EQ(faces.NeighbourOf(other.element, other.face), (ElementFace{ e, f }));
    }
  }
}

inline void ExpectClosed(const Mesh& mesh, const FaceTable& faces)
{
  const SurfaceIntegrals integrals = IntegrateBoundary(mesh, faces);
  EXPECT_LT(LargestOf(integrals.area), 1e-11 * integrals.surface);
  EXPECT_NEAR(integrals.volume, integrals.inside, 1e-11 * integrals.inside);
}

/// A unit cube at `corner`, its points moved by `bend`.
inline void AddCube(
  MeshBuilder& mesh, const Vec3& corner, const MeshBuilder::Map& bend = {}, double side = 1.0)
{
  mesh.Add(UniformSpace(Shape::Hexahedron, bend ? 3 : 1),
    [=](const LongVec3& xi)
    {
      LongVec3 x;
      for (int d = 0; d < 3; ++d)
      {
        x[d] = corner[d] + side * (xi[d] + 1) / 2;
      }
      return bend ? bend(x) : x;
    });
}

inline FaceTable TableOf(const MeshBuilder& mesh)
{
  const Mesh view = mesh.View();
  const ElementIndex index(view);
  return FaceTable(index);
}
} // namespace pixelexact::testing
