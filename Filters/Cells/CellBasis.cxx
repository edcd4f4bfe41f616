// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellBasis.h"

#include "Core/Base/Error.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkCell> Instantiate(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
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
  if (IsHigherOrderPlaneCell(kind.type))
  {
    return MakeHigherOrderPlaneCellBasis(kind);
  }
  if (IsHigherOrderCell(kind.type))
  {
    return MakeHigherOrderCellBasis(kind);
  }
  throw Unsupported(CellTypeName(kind.type) +
    " is not supported: it is no polynomial on a tetrahedron, hexahedron, wedge or pyramid, "
    "triangle "
    "or quadrilateral whose nodes VTK defines; take out such cells (vtkExtractCells) or split "
    "them.");
}
} // namespace pixelexact
