// SPDX-License-Identifier: BSD-3-Clause
// VTK's triangles and quadrilaterals of any order, in the spaces of a slab's solids. The numbering
// of nodes is taken from VTK's own classes, as in HigherOrderCells.cxx.
#include "Cells/CellBasis.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include "vtkCellType.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTriangle.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// The triangle of order 2 with a bubble.
constexpr int kBubbleTriangle = 7;

[[noreturn]] void RefuseCount(const CellKind& kind)
{
  throw InvalidData(CellTypeName(kind.type) + " with " + Counted(kind.points, "point") +
    " is of no order from 1 to " + std::to_string(kMaxOrder) +
    "; where its directions differ, the file needs the cell array HigherOrderDegrees.");
}

CellBasis Quadrilateral(const CellKind& kind)
{
  std::array<int, 2> n{ kind.degrees[0], kind.degrees[1] };
  const bool given = n != std::array{ 0, 0 };
  if (!given)
  {
    int order = 1;
    while ((order + 1) * (order + 1) < kind.points && order < kMaxOrder)
    {
      ++order;
    }
    n = { order, order };
  }
  if (std::ranges::min(n) < 1 || std::ranges::max(n) > kMaxOrder ||
    (n[0] + 1) * (n[1] + 1) != kind.points)
  {
    if (!given)
    {
      RefuseCount(kind);
    }
    throw InvalidData(CellTypeName(kind.type) + " with " + Counted(kind.points, "point") +
      " contradicts its HigherOrderDegrees " + std::to_string(n[0]) + ", " + std::to_string(n[1]) +
      "; correct that cell array.");
  }
  std::vector<int> source;
  std::array<std::vector<int>, 3> edges;
  for (int i = 0; i <= n[0]; ++i)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      source.push_back(vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, n.data()));
      for (std::size_t d = 0; d < 2; ++d)
      {
        if ((d == 0 ? j : i) == 0)
        {
          edges[d].push_back(source.back());
        }
      }
    }
  }
  const auto order = [&](std::size_t d) { return static_cast<std::uint8_t>(n[d]); };
  const Space space{ Shape::Hexahedron, Form::Collapsed, { order(0), order(1), 0 } };
  return { kind, ChangeOfBasis::Hexahedron(space, FamilyOf(kind), source), std::move(edges), {},
    source };
}

CellBasis Triangle(const CellKind& kind)
{
  int n = 1;
  while ((n + 1) * (n + 2) / 2 < kind.points && n < kMaxOrder)
  {
    ++n;
  }
  if ((n + 1) * (n + 2) / 2 != kind.points)
  {
    RefuseCount(kind);
  }
  RequireKnownNodes(kind, n);
  std::vector<int> source;
  std::array<std::vector<int>, 3> edges;
  for (vtkIdType i = 0; i <= n; ++i)
  {
    for (vtkIdType j = 0; j <= n - i; ++j)
    {
      const vtkIdType index[3] = { i, j, n - i - j };
      source.push_back(static_cast<int>(vtkHigherOrderTriangle::Index(index, n)));
      if (j == 0)
      {
        edges[0].push_back(source.back());
      }
      if (i == 0)
      {
        edges[1].push_back(source.back());
      }
    }
  }
  const auto order = static_cast<std::uint8_t>(n);
  const Space space{ Shape::Prism, Form::Collapsed, { order, 0, order } };
  return { kind, ChangeOfBasis::Prism(space, FamilyOf(kind), source), std::move(edges), {},
    source };
}
} // namespace

bool IsHigherOrderPlaneCell(int type)
{
  return type == VTK_LAGRANGE_TRIANGLE || type == VTK_LAGRANGE_QUADRILATERAL ||
    type == VTK_BEZIER_TRIANGLE || type == VTK_BEZIER_QUADRILATERAL;
}

CellBasis MakeHigherOrderPlaneCellBasis(const CellKind& kind)
{
  if (kind.type == VTK_LAGRANGE_TRIANGLE && kind.points == kBubbleTriangle)
  {
    return { kind, SampleCell(kind, { Shape::Prism, Form::Collapsed, { 3, 0, 3 } }), {} };
  }
  const bool isTriangle = kind.type == VTK_LAGRANGE_TRIANGLE || kind.type == VTK_BEZIER_TRIANGLE;
  CellBasis basis = isTriangle ? Triangle(kind) : Quadrilateral(kind);
  if (!IsLagrangeCell(kind.type))
  {
    basis.edges = {}; // control points are not on the edges
  }
  return basis;
}
} // namespace pixelexact
