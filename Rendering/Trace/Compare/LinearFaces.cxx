// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Compare/LinearFaces.h"

#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"
#include "Trace/Scene.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace pixelexact
{
namespace
{
std::size_t TrianglesOf(const ReferenceFace& face, int parts)
{
  const auto squares = static_cast<std::size_t>(parts) * static_cast<std::size_t>(parts);
  return face.corners == 4 ? 2 * squares : squares;
}

/// The lattice points of a face, and the triangles' corners as numbers of these points.
struct FaceLattice
{
  FaceLattice(const ReferenceFace& face, int parts)
  {
    const auto across = static_cast<std::size_t>(parts) + 1;
    std::vector<int> number(across * across);
    const auto at = [&](int i, int j) -> int&
    { return number[static_cast<std::size_t>(j) * across + static_cast<std::size_t>(i)]; };
    const bool square = face.corners == 4;
    for (int j = 0; j <= parts; ++j)
    {
      for (int i = 0; i <= (square ? parts : parts - j); ++i)
      {
        at(i, j) = static_cast<int>(xi.size());
        xi.push_back(face.At({ static_cast<double>(i) / parts, static_cast<double>(j) / parts }));
      }
    }
    for (int j = 0; j < parts; ++j)
    {
      for (int i = 0; i < (square ? parts : parts - j); ++i)
      {
        triangles.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
        if (square || i + j < parts - 1)
        {
          triangles.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }

  std::vector<Vec3> xi;
  std::vector<std::array<int, 3>> triangles;
};
} // namespace

std::size_t CountTriangles(const Mesh& mesh, std::span<const ElementFace> faces, int parts)
{
  std::size_t count = 0;
  for (const ElementFace& face : faces)
  {
    count += TrianglesOf(ReferenceFaceOf(mesh.ShapeOf(face.element), face.face), parts);
  }
  return count;
}

LinearSurface TrianglesOfFaces(const Mesh& mesh, const Field& field, int component,
  std::span<const ElementFace> faces, int parts)
{
  std::vector<std::size_t> begin(faces.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < faces.size(); ++k)
  {
    begin[k] = count;
    count += TrianglesOf(ReferenceFaceOf(mesh.ShapeOf(faces[k].element), faces[k].face), parts);
  }
  std::vector<Triangles::Triangle> triangles(count);
  std::vector<std::array<double, 3>> values(count);
  const auto components = static_cast<std::size_t>(field.values.components);
  tbb::parallel_for(std::size_t{ 0 }, faces.size(),
    [&](std::size_t k)
    {
      const auto [element, face] = faces[k];
      const FaceLattice lattice(ReferenceFaceOf(mesh.ShapeOf(element), face), parts);
      std::vector<Vec3> x(lattice.xi.size());
      std::vector<double> u(lattice.xi.size() * components);
      MapForward(mesh, element, lattice.xi, x);
      EvaluateAt(mesh, field, element, lattice.xi, u, {});
      for (std::size_t t = 0; t < lattice.triangles.size(); ++t)
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          const auto corner = static_cast<std::size_t>(lattice.triangles[t][c]);
          triangles[begin[k] + t][c] = x[corner];
          values[begin[k] + t][c] =
            ComponentOf(std::span(u).subspan(corner * components, components), component);
        }
      }
    });
  return { std::move(triangles), std::move(values) };
}
} // namespace pixelexact
