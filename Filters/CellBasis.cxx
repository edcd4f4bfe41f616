// SPDX-License-Identifier: BSD-3-Clause
#include "CellBasis.h"

#include "Core/Base/Error.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkCell> Instantiate(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
}

/// VTK's parametric coordinates of reference coordinates, for cells of fixed order.
std::array<double, 3> Parametric(int type, Shape shape, const LongVec3& xi)
{
  const auto half = [](long double v) { return static_cast<double>((1 + v) / 2); };
  switch (shape)
  {
    case Shape::Prism:
      return { half(xi[0]), half(xi[2]), half(-xi[1]) };
    case Shape::Pyramid:
    {
      // The points sampled keep off the apex.
      const long double collapse = (1 - xi[2]) / 2;
      if (type == VTK_TRIQUADRATIC_PYRAMID)
      {
        // This one cell has the pyramid itself: |2 r - 1|, |2 s - 1| <= 1 - T, t = (1 + T) / 2.
        const long double T = (1 + xi[2]) / 2;
        return { half(xi[0] + 1 - collapse), half(xi[1] + 1 - collapse), half(T) };
      }
      return { half((1 + xi[0]) / collapse - 1), half((1 + xi[1]) / collapse - 1), half(xi[2]) };
    }
    default:
      return { half(xi[0]), half(xi[1]), half(xi[2]) };
  }
}
} // namespace

std::string CellTypeName(int type)
{
  // VTK has the types of these two, but no classes.
  if (type == VTK_LAGRANGE_PYRAMID || type == VTK_BEZIER_PYRAMID)
  {
    return type == VTK_LAGRANGE_PYRAMID ? "VTK_LAGRANGE_PYRAMID" : "VTK_BEZIER_PYRAMID";
  }
  const auto cell = Instantiate(type);
  return cell ? cell->GetClassName() : "cell type " + std::to_string(type);
}

int CellDimension(int type)
{
  const auto cell = Instantiate(type);
  return cell ? cell->GetCellDimension() : -1;
}

CellBasis MakeCellBasis(const CellKind& kind)
{
  if (IsFixedCell(kind.type))
  {
    return MakeFixedCellBasis(kind);
  }
  if (IsHigherOrderCell(kind.type))
  {
    return MakeHigherOrderCellBasis(kind);
  }
  throw Unsupported(CellTypeName(kind.type) +
    " is not supported: it is no polynomial on a tetrahedron, hexahedron, wedge or pyramid whose "
    "nodes VTK defines; take out such cells (vtkExtractCells) or split them.");
}

ChangeOfBasis SampleCell(const CellKind& kind, const Space& space)
{
  const auto cell = Instantiate(kind.type);
  cell->GetPoints()->SetNumberOfPoints(kind.points);
  cell->GetPointIds()->SetNumberOfIds(kind.points);
  for (int i = 0; i < kind.points; ++i)
  {
    cell->GetPoints()->SetPoint(i, 0.0, 0.0, 0.0);
    cell->GetPointIds()->SetId(i, i);
  }
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->SetUniformOrderFromNumPoints(kind.points);
  }
  if (cell->RequiresInitialization())
  {
    cell->Initialize();
  }
  std::vector<double> weights(kind.points);
  return ChangeOfBasis::FromFunctions(space, kind.points,
    [&](const LongVec3& xi, long double* values)
    {
      const auto at = Parametric(kind.type, space.shape, xi);
      cell->InterpolateFunctions(at.data(), weights.data());
      std::copy(weights.begin(), weights.end(), values);
    });
}
} // namespace pixelexact
