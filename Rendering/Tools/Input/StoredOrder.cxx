// SPDX-License-Identifier: BSD-3-Clause
#include "Input/StoredOrder.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace pixelexact
{
namespace
{
/// The order n at which points(n) is the number of points; 0 where there is none.
template <class Points>
int OrderOf(vtkIdType count, const Points& points)
{
  vtkIdType order = 1;
  while (points(order) < count)
  {
    ++order;
  }
  return points(order) == count ? static_cast<int>(order) : 0;
}

int HigherOrder(int type, vtkIdType points)
{
  switch (type)
  {
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return OrderOf(points, [](vtkIdType n) { return (n + 1) * (n + 2) * (n + 3) / 6; });
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return OrderOf(points, [](vtkIdType n) { return (n + 1) * (n + 2) / 2; });
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return OrderOf(points, [](vtkIdType n) { return (n + 1) * (n + 1); });
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return OrderOf(points, [](vtkIdType n) { return (n + 1) * (n + 1) * (n + 2) / 2; });
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return OrderOf(points, [](vtkIdType n) { return (n + 1) * (n + 1) * (n + 1); });
    default:
      return 0;
  }
}
} // namespace

int StoredOrder(vtkUnstructuredGrid& grid, vtkIdType cell)
{
  const int type = grid.GetCellType(cell);
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_TETRA:
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
    case VTK_WEDGE:
    case VTK_PYRAMID:
      return 1;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_TETRA:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      return 2;
    default:
      break;
  }
  // Cells whose orders differ by direction store them.
  vtkDataArray* degrees = grid.GetCellData()->GetHigherOrderDegrees();
  if (degrees != nullptr && degrees->GetNumberOfComponents() == 3)
  {
    double degree[3];
    degrees->GetTuple(cell, degree);
    const double highest = *std::max_element(degree, degree + 3);
    if (highest >= 1.0 && highest < 100.0)
    {
      return static_cast<int>(highest);
    }
  }
  return HigherOrder(type, grid.GetCells()->GetCellSize(cell));
}
} // namespace pixelexact
