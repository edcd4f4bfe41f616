// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellNodes.h"

#include "Cells/LinearCell.h"
#include "Core/Element/Mesh.h"

#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkLagrangeWedge.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTetra.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pixelexact
{
namespace
{
void Place(CellNodes& cell, vtkIdType index, CellNode node)
{
  const int divisor = std::accumulate(node.weight.begin(), node.weight.end(), 0,
    [](int so_far, int weight) { return std::gcd(so_far, weight); });
  std::ranges::transform(
    node.weight, node.weight.begin(), [divisor](int weight) { return weight / divisor; });
  if (cell.nodes.size() <= static_cast<std::size_t>(index))
  {
    cell.nodes.resize(static_cast<std::size_t>(index) + 1);
  }
  cell.nodes[static_cast<std::size_t>(index)] = node;
}

CellNodes HexahedronNodes(const CellDegrees& degrees)
{
  CellNodes cell{ VTK_LAGRANGE_HEXAHEDRON, 8, {} };
  const int n[3] = { degrees[0], degrees[1], degrees[2] };
  for (int k = 0; k <= n[2]; ++k)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      for (int i = 0; i <= n[0]; ++i)
      {
        const int r[2] = { n[0] - i, i };
        const int s[2] = { n[1] - j, j };
        const int t[2] = { n[2] - k, k };
        CellNode node;
        for (std::size_t c = 0; c < 8; ++c)
        {
          const bool isRight = c % 4 == 1 || c % 4 == 2;
          node.weight[c] = r[isRight ? 1 : 0] * s[c % 4 / 2] * t[c / 4];
        }
        Place(cell, vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, n), node);
      }
    }
  }
  return cell;
}

CellNodes WedgeNodes(const CellDegrees& degrees)
{
  CellNodes cell{ VTK_LAGRANGE_WEDGE, 6, {} };
  const int n = degrees[0];
  const int line = degrees[2];
  // VTK reads the fourth entry only to refuse 21, the number of points of the wedge with bubbles.
  const int order[4] = { n, n, line, 0 };
  for (int k = 0; k <= line; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n - j; ++i)
      {
        const int triangle[3] = { n - i - j, i, j };
        CellNode node;
        for (std::size_t c = 0; c < 6; ++c)
        {
          node.weight[c] = triangle[c % 3] * (c < 3 ? line - k : k);
        }
        Place(cell, vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, order), node);
      }
    }
  }
  return cell;
}

CellNodes TetrahedronNodes(int degree)
{
  CellNodes cell{ VTK_LAGRANGE_TETRAHEDRON, 4, {} };
  for (int k = 0; k <= degree; ++k)
  {
    for (int j = 0; j <= degree - k; ++j)
    {
      for (int i = 0; i <= degree - j - k; ++i)
      {
        const vtkIdType index[4] = { i, j, k, degree - i - j - k };
        Place(cell, vtkHigherOrderTetra::Index(index, degree),
          { { degree - i - j - k, i, j, k, 0, 0, 0, 0 } });
      }
    }
  }
  return cell;
}

/// The volume, signed, of the tetrahedra into which VTK cuts a Lagrange wedge of degree 2, whose
/// corners lie at `places`.
double VolumeOfTetrahedra(std::span<const Vec3> places)
{
  const std::vector<Vec3> points = WedgeNodes({ 2, 2, 2 }).Between(places);
  const auto count = static_cast<vtkIdType>(points.size());
  vtkNew<vtkLagrangeWedge> cell;
  cell->GetPoints()->SetDataTypeToDouble();
  cell->GetPoints()->SetNumberOfPoints(count);
  cell->GetPointIds()->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vec3& x = points[static_cast<std::size_t>(i)];
    cell->GetPoints()->SetPoint(i, x.x, x.y, x.z);
    cell->GetPointIds()->SetId(i, i);
  }
  cell->SetUniformOrderFromNumPoints(count);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  cell->Triangulate(0, ids, corners);
  double sum = 0.0;
  for (vtkIdType k = 0; k + 3 < corners->GetNumberOfPoints(); k += 4)
  {
    std::array<std::array<double, 3>, 4> p{};
    for (vtkIdType c = 0; c < 4; ++c)
    {
      corners->GetPoint(k + c, p[static_cast<std::size_t>(c)].data());
    }
    sum += vtkTetra::ComputeVolume(p[0].data(), p[1].data(), p[2].data(), p[3].data());
  }
  return sum;
}

CellNodes LinearNodes(Shape shape)
{
  const LinearCell& linear = LinearCellOf(shape);
  CellNodes cell{ linear.type, static_cast<int>(linear.corners.size()), {} };
  for (std::size_t c = 0; c < linear.corners.size(); ++c)
  {
    CellNode node;
    node.weight[c] = 1;
    cell.nodes.push_back(node);
  }
  return cell;
}
} // namespace

int CellNode::CornerCount() const
{
  return static_cast<int>(std::ranges::count_if(weight, [](int own) { return own != 0; }));
}

std::vector<Vec3> CellNodes::Between(std::span<const Vec3> cornerPlaces) const
{
  std::vector<Vec3> places(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    Vec3 sum(0.0);
    int total = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(corners); ++c)
    {
      sum += static_cast<double>(nodes[i].weight[c]) * cornerPlaces[c];
      total += nodes[i].weight[c];
    }
    places[i] = sum / static_cast<double>(total);
  }
  return places;
}

bool CellNodes::IsWoundAgainstLinear() const
{
  if (type != VTK_LAGRANGE_WEDGE)
  {
    return false;
  }
  static const bool isAgainst = []
  {
    const std::vector<Vec3>& prism = LinearCellOf(Shape::Prism).corners;
    return VolumeOfTetrahedra(prism) * VolumeOf(VTK_WEDGE, prism) < 0.0;
  }();
  return isAgainst;
}

bool CellNodes::IsOnBoundary(const CellNode& node) const
{
  return node.CornerCount() < corners;
}

CellNodes MakeCellNodes(Shape shape, const CellDegrees& degrees)
{
  if (shape == Shape::Pyramid || degrees == CellDegrees{ 1, 1, 1 })
  {
    return LinearNodes(shape);
  }
  switch (shape)
  {
    case Shape::Hexahedron:
      return HexahedronNodes(degrees);
    case Shape::Prism:
      return WedgeNodes(degrees);
    default:
      return TetrahedronNodes(degrees[0]);
  }
}

CellDegrees CellDegreesOf(const Space& space)
{
  const auto degree = [](int order)
  { return static_cast<unsigned char>(std::clamp(order, 1, kMaxCellDegree)); };
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return { degree(space.order[0]), degree(space.order[1]), degree(space.order[2]) };
    case Shape::Prism:
      return { degree(space.order[2]), degree(space.order[2]), degree(space.order[1]) };
    case Shape::Tetrahedron:
      return { degree(space.order[2]), degree(space.order[2]), degree(space.order[2]) };
    default:
      return { 1, 1, 1 };
  }
}

std::vector<std::size_t> UnmirroredOrder(const CellNodes& cell)
{
  const auto corners = static_cast<std::size_t>(cell.corners);
  std::array<int, 8> cornerOf{};
  std::iota(cornerOf.begin(), cornerOf.end(), 0);
  Mirror(std::span(cornerOf).first(corners));
  std::map<std::array<int, 8>, std::size_t> places;
  for (std::size_t k = 0; k < cell.nodes.size(); ++k)
  {
    places[cell.nodes[k].weight] = k;
  }
  std::vector<std::size_t> order(cell.nodes.size());
  for (std::size_t m = 0; m < cell.nodes.size(); ++m)
  {
    std::array<int, 8> weight{};
    for (std::size_t c = 0; c < corners; ++c)
    {
      weight[static_cast<std::size_t>(cornerOf[c])] = cell.nodes[m].weight[c];
    }
    order[places.at(weight)] = m;
  }
  return order;
}

ElementCells::ElementCells(const Mesh& mesh, std::span<const CellDegrees> degrees)
{
  const auto elements = static_cast<std::size_t>(mesh.Elements());
  std::vector<char> isNegative(elements);
  tbb::parallel_for(tbb::blocked_range<int>(0, mesh.Elements(), 64),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int e = range.begin(); e < range.end(); ++e)
      {
        isNegative[static_cast<std::size_t>(e)] = IsMirrored(mesh, e) ? 1 : 0;
      }
    });
  Cells.resize(elements);
  for (std::size_t e = 0; e < elements; ++e)
  {
    const Shape shape = mesh.ShapeOf(static_cast<int>(e));
    const bool isLinearNegative = isNegative[e] != 0;
    const auto [at, isNew] = Kinds.try_emplace({ shape, degrees[e], isLinearNegative });
    if (isNew)
    {
      CellNodes nodes = MakeCellNodes(shape, degrees[e]);
      const bool mirror = isLinearNegative != nodes.IsWoundAgainstLinear();
      std::vector<Vec3> corners = LinearCellOf(shape).corners;
      if (mirror)
      {
        Mirror(std::span(corners));
      }
      std::vector<Vec3> xi = nodes.Between(corners);
      at->second = { std::move(nodes), mirror, std::move(xi) };
    }
    Cells[e] = &at->second;
  }
}
} // namespace pixelexact
