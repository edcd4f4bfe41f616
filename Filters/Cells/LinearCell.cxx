// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/LinearCell.h"

#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"

#include "vtkCell3D.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

#include <array>

namespace pixelexact
{
namespace
{
/// The number of the shape's face whose corners have this centre.
int FaceAt(Shape shape, const Vec3& centre)
{
  int nearest = 0;
  double least = 1e300;
  for (int f = 0; f < static_cast<int>(FacesOf(shape).size()); ++f)
  {
    const ReferenceFace& face = ReferenceFaceOf(shape, f);
    Vec3 sum(0.0);
    for (int k = 0; k < face.corners; ++k)
    {
      sum += face.corner[static_cast<std::size_t>(k)];
    }
    const double distance = glm::distance(sum / static_cast<double>(face.corners), centre);
    if (distance < least)
    {
      least = distance;
      nearest = f;
    }
  }
  return nearest;
}

/// The faces of a linear cell by its corners, as VTK winds them.
using Faces = std::vector<std::vector<std::size_t>>;

Faces MakeFaces(int type)
{
  const auto made = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  auto* solid = vtkCell3D::SafeDownCast(made);
  Faces faces;
  for (int f = 0; f < solid->GetNumberOfFaces(); ++f)
  {
    const vtkIdType* points = nullptr;
    const vtkIdType count = solid->GetFacePoints(f, points);
    faces.emplace_back(points, points + count);
  }
  return faces;
}

const Faces& FacesOfCell(int type)
{
  static const Faces hexahedron = MakeFaces(VTK_HEXAHEDRON);
  static const Faces wedge = MakeFaces(VTK_WEDGE);
  static const Faces tetrahedron = MakeFaces(VTK_TETRA);
  static const Faces pyramid = MakeFaces(VTK_PYRAMID);
  switch (type)
  {
    case VTK_HEXAHEDRON:
      return hexahedron;
    case VTK_WEDGE:
      return wedge;
    case VTK_TETRA:
      return tetrahedron;
    default:
      return pyramid;
  }
}

LinearCell Make(Shape shape, int type, std::vector<Vec3> corners)
{
  LinearCell cell{ type, std::move(corners), {} };
  for (const auto& face : FacesOfCell(type))
  {
    Vec3 sum(0.0);
    for (const std::size_t corner : face)
    {
      sum += cell.corners[corner];
    }
    cell.faceOf.push_back(FaceAt(shape, sum / static_cast<double>(face.size())));
  }
  return cell;
}
} // namespace

double VolumeOf(int type, std::span<const Vec3> places)
{
  double sum = 0.0;
  for (const auto& face : FacesOfCell(type))
  {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      const Vec3 a = places[face[0]] - places[0];
      sum += glm::dot(a, glm::cross(places[face[k]] - places[0], places[face[k + 1]] - places[0]));
    }
  }
  return sum / 6.0;
}

int MirroredFace(int type, int face)
{
  const Faces& faces = FacesOfCell(type);
  std::array<std::size_t, 8> mirrored{ 0, 1, 2, 3, 4, 5, 6, 7 };
  const std::size_t corners = type == VTK_HEXAHEDRON ? 8
    : type == VTK_WEDGE                              ? 6
    : type == VTK_PYRAMID                            ? 5
                                                     : 4;
  Mirror(std::span(mirrored).first(corners));
  std::vector<std::size_t> now = faces[static_cast<std::size_t>(face)];
  std::ranges::transform(now, now.begin(), [&](std::size_t corner) { return mirrored[corner]; });
  const auto same = std::ranges::find_if(
    faces, [&](const auto& other) { return std::ranges::is_permutation(now, other); });
  return static_cast<int>(same - faces.begin());
}

bool IsMirrored(const Mesh& mesh, int element)
{
  const LinearCell& cell = LinearCellOf(mesh.ShapeOf(element));
  std::array<Vec3, 8> room;
  const std::span places = std::span(room).first(cell.corners.size());
  MapForward(mesh, element, cell.corners, places);
  return VolumeOf(cell.type, places) < 0.0;
}

const LinearCell& LinearCellOf(Shape shape)
{
  static const LinearCell hexahedron = Make(Shape::Hexahedron, VTK_HEXAHEDRON,
    { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 },
      { 1, 1, 1 }, { -1, 1, 1 } });
  static const LinearCell prism = Make(Shape::Prism, VTK_WEDGE,
    { { -1, 1, -1 }, { 1, 1, -1 }, { -1, 1, 1 }, { -1, -1, -1 }, { 1, -1, -1 }, { -1, -1, 1 } });
  static const LinearCell tetrahedron = Make(
    Shape::Tetrahedron, VTK_TETRA, { { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } });
  static const LinearCell pyramid = Make(Shape::Pyramid, VTK_PYRAMID,
    { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } });
  switch (shape)
  {
    case Shape::Hexahedron:
      return hexahedron;
    case Shape::Prism:
      return prism;
    case Shape::Tetrahedron:
      return tetrahedron;
    default:
      return pyramid;
  }
}
} // namespace pixelexact
