// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/LinearCell.h"

#include "Core/Faces/ReferenceFace.h"
#include "Core/Questions/Questions.h"

#include "vtkCell3D.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

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

LinearCell Make(Shape shape, int type, std::vector<Vec3> corners)
{
  LinearCell cell{ type, std::move(corners), {} };
  const auto made = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  auto* solid = vtkCell3D::SafeDownCast(made);
  for (int f = 0; f < solid->GetNumberOfFaces(); ++f)
  {
    const vtkIdType* points = nullptr;
    const vtkIdType count = solid->GetFacePoints(f, points);
    Vec3 sum(0.0);
    for (vtkIdType k = 0; k < count; ++k)
    {
      sum += cell.corners[static_cast<std::size_t>(points[k])];
    }
    cell.faceOf.push_back(FaceAt(shape, sum / static_cast<double>(count)));
  }
  return cell;
}
} // namespace

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
