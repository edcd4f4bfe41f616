// SPDX-License-Identifier: BSD-3-Clause
// The numbering of nodes is taken from VTK's own classes, so that it follows the VTK that is built
// against.
#include "Cells/CellBasis.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkHigherOrderWedge.h"

#include <algorithm>
#include <optional>

namespace pixelexact
{
namespace
{
/// Up to this order Gauss-Lobatto-Legendre nodes inside triangles have unique positions.
constexpr int kUniqueTriangle = 3;

/// The family of functions that belongs to the kind's nodes or control points.
Family FamilyOf(const CellKind& kind)
{
  if (!IsLagrangeCell(kind.type))
  {
    return Family::Bernstein;
  }
  return kind.nodes.gaussLobatto ? Family::GaussLobattoLagrange : Family::EquispacedLagrange;
}

/// Throws Unsupported where solvers place the nodes inside triangles of this order differently.
void RequireKnownNodes(const CellKind& kind, int triangleOrder)
{
  if (FamilyOf(kind) == Family::GaussLobattoLagrange && triangleOrder > kUniqueTriangle)
  {
    throw Unsupported(CellTypeName(kind.type) + " of order " + std::to_string(triangleOrder) +
      " with Gauss-Lobatto-Legendre nodes (SetNodePlacement, --nodes gll): above order " +
      std::to_string(kUniqueTriangle) +
      " solvers place the nodes inside triangles in several ways "
      "(warped, blended, Fekete), and the file does not state which; write it with equispaced "
      "nodes "
      "(DOLFINx: basix.LagrangeVariant.equispaced).");
  }
}

int NumberOfPoints(Shape shape, const std::array<int, 3>& n)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
    case Shape::Prism:
      return (n[0] + 1) * (n[0] + 2) / 2 * (n[2] + 1);
    default:
      return (n[0] + 1) * (n[0] + 2) * (n[0] + 3) / 6;
  }
}

/// Degrees along r, s, t: given, or uniform from the number of points.
std::array<int, 3> DegreesOf(const CellKind& kind, Shape shape)
{
  auto n = kind.degrees;
  const bool given = n != std::array<int, 3>{ 0, 0, 0 } && shape != Shape::Tetrahedron;
  if (!given)
  {
    n = { 1, 1, 1 };
    while (NumberOfPoints(shape, n) < kind.points && n[0] < kMaxOrder)
    {
      n = { n[0] + 1, n[0] + 1, n[0] + 1 };
    }
  }
  const std::string points = Counted(kind.points, "point");
  if (*std::ranges::min_element(n) < 1 || *std::ranges::max_element(n) > kMaxOrder ||
    (shape == Shape::Prism && n[0] != n[1]) || NumberOfPoints(shape, n) != kind.points)
  {
    throw InvalidData(CellTypeName(kind.type) + " with " + points +
      (given ? " contradicts its HigherOrderDegrees " + std::to_string(n[0]) + ", " +
            std::to_string(n[1]) + ", " + std::to_string(n[2]) + "; correct that cell array."
             : " is of no order from 1 to " + std::to_string(kMaxOrder) +
            "; where its directions differ, the file needs the cell array HigherOrderDegrees."));
  }
  return n;
}

Space SpaceOf(Shape shape, const std::array<int, 3>& n)
{
  const auto order = [&](int d) { return static_cast<std::uint8_t>(n[d]); };
  // Our prism has its line in the middle, VTK's wedge last.
  return shape == Shape::Prism ? Space{ shape, Form::Collapsed, { order(0), order(2), order(0) } }
                               : Space{ shape, Form::Collapsed, { order(0), order(1), order(2) } };
}

CellBasis Hexahedron(const CellKind& kind, const std::array<int, 3>& n)
{
  std::vector<int> source;
  std::array<std::vector<int>, 3> edges;
  for (int i = 0; i <= n[0]; ++i)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      for (int k = 0; k <= n[2]; ++k)
      {
        source.push_back(vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, n.data()));
        const bool onEdge[3] = { j + k == 0, i + k == 0, i + j == 0 };
        for (int d = 0; d < 3; ++d)
        {
          if (onEdge[d])
          {
            edges[d].push_back(source.back());
          }
        }
      }
    }
  }
  return { kind, ChangeOfBasis::Hexahedron(SpaceOf(Shape::Hexahedron, n), FamilyOf(kind), source),
    std::move(edges), {}, source };
}

int WedgeNode(int i, int j, int k, const std::array<int, 3>& n)
{
  // VTK's fourth entry is the number of points and read only to refuse 21, the wedge with bubbles.
  const int order[4] = { n[0], n[1], n[2], 0 };
  return vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, order);
}

std::vector<int> WedgeSource(const std::array<int, 3>& n, bool mirrored)
{
  std::vector<int> source;
  for (int i = 0; i <= n[0]; ++i)
  {
    for (int j = 0; j <= n[0] - i; ++j)
    {
      for (int line = 0; line <= n[2]; ++line)
      {
        const int k = n[2] - line; // t runs against xi2
        const bool inFace = i == 0 && j > 0 && j < n[0] && k > 0 && k < n[2];
        source.push_back(WedgeNode(i, mirrored && inFace ? n[0] - j : j, k, n));
      }
    }
  }
  return source;
}

ChangeOfBasis Wedge(const CellKind& kind, const std::array<int, 3>& n, bool mirrored)
{
  RequireKnownNodes(kind, n[0]);
  return ChangeOfBasis::Prism(SpaceOf(Shape::Prism, n), FamilyOf(kind), WedgeSource(n, mirrored));
}

CellBasis Tetrahedron(const CellKind& kind, const std::array<int, 3>& n)
{
  RequireKnownNodes(kind, n[0]);
  std::vector<int> source;
  std::array<std::vector<int>, 3> edges;
  const int order = n[0];
  for (vtkIdType i = 0; i <= order; ++i)
  {
    for (vtkIdType j = 0; j <= order - i; ++j)
    {
      for (vtkIdType k = 0; k <= order - i - j; ++k)
      {
        const vtkIdType index[4] = { i, j, k, order - i - j - k };
        source.push_back(static_cast<int>(vtkHigherOrderTetra::Index(index, order)));
        const bool onEdge[3] = { j + k == 0, i + k == 0, i + j == 0 };
        for (int d = 0; d < 3; ++d)
        {
          if (onEdge[d])
          {
            edges[d].push_back(source.back());
          }
        }
      }
    }
  }
  return { kind, ChangeOfBasis::Tetrahedron(SpaceOf(Shape::Tetrahedron, n), FamilyOf(kind), source),
    std::move(edges), {}, source };
}

CellBasis WedgeBasis(const CellKind& kind, const std::array<int, 3>& n)
{
  std::array<std::vector<int>, 3> edges;
  for (int i = 0; i <= n[0]; ++i)
  {
    edges[0].push_back(WedgeNode(i, 0, 0, n));
    edges[1].push_back(WedgeNode(0, i, 0, n));
  }
  for (int k = 0; k <= n[2]; ++k)
  {
    edges[2].push_back(WedgeNode(0, 0, k, n));
  }
  return { kind, Wedge(kind, n, kind.nodes.mirroredWedges), std::move(edges), {},
    WedgeSource(n, kind.nodes.mirroredWedges) };
}

/// The space of Lagrange cells that have bubble functions in addition to the complete polynomials.
std::optional<Space> BubbleSpace(const CellKind& kind)
{
  if (kind.type == VTK_LAGRANGE_TETRAHEDRON && kind.points == 15)
  {
    return UniformSpace(Shape::Tetrahedron, 4);
  }
  const bool quadratic =
    kind.degrees == std::array{ 0, 0, 0 } || kind.degrees == std::array{ 2, 2, 2 };
  if (kind.type == VTK_LAGRANGE_WEDGE && kind.points == 21 && quadratic)
  {
    return Space{ Shape::Prism, Form::Collapsed, { 3, 2, 3 } };
  }
  return std::nullopt;
}

// VTK's triangles and quadrilaterals of any order, in the spaces of a slab's solids.

/// Number of points of the triangle of order 2 with a bubble.
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

bool IsLagrangeCell(int type)
{
  return type == VTK_LAGRANGE_TRIANGLE || type == VTK_LAGRANGE_QUADRILATERAL ||
    type == VTK_LAGRANGE_TETRAHEDRON || type == VTK_LAGRANGE_HEXAHEDRON ||
    type == VTK_LAGRANGE_WEDGE;
}

bool IsHigherOrderCell(int type)
{
  switch (type)
  {
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_TETRAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
    case VTK_BEZIER_WEDGE:
      return true;
    default:
      return false;
  }
}

CellBasis MakeHigherOrderCellBasis(const CellKind& kind)
{
  if (const auto space = BubbleSpace(kind))
  {
    return { kind, SampleCell(kind, *space), {} };
  }
  CellBasis basis = [&]
  {
    switch (kind.type)
    {
      case VTK_LAGRANGE_HEXAHEDRON:
      case VTK_BEZIER_HEXAHEDRON:
        return Hexahedron(kind, DegreesOf(kind, Shape::Hexahedron));
      case VTK_LAGRANGE_WEDGE:
      case VTK_BEZIER_WEDGE:
        return WedgeBasis(kind, DegreesOf(kind, Shape::Prism));
      default:
        return Tetrahedron(kind, DegreesOf(kind, Shape::Tetrahedron));
    }
  }();
  if (!IsLagrangeCell(kind.type))
  {
    basis.edges = {}; // control points are not on the edges
  }
  return basis;
}

ChangeOfBasis MakeOtherWedge(const CellKind& kind)
{
  return Wedge(kind, DegreesOf(kind, Shape::Prism), !kind.nodes.mirroredWedges);
}

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
