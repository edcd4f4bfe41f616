// SPDX-License-Identifier: BSD-3-Clause
#include "Files/SolverCells.h"

#include "Cells/LinearCell.h"
#include "Core/Location/Sample.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

namespace pixelexact
{
namespace
{
/// Nodes with the same name whose distance is below this, in element sizes, become one point. This
/// affects the cells, not the elements.
constexpr double kSamePoint = 1e-9;

/// The name of a node on a vertex, edge or face: the points at the corners and its weights there.
struct NodeName
{
  struct Corner
  {
    vtkIdType point = -1;
    std::int64_t weight = 0;

    bool operator==(const Corner&) const = default;
  };
  std::array<Corner, 4> corners{};

  bool operator==(const NodeName&) const = default;
};

struct NameHash
{
  std::size_t operator()(const NodeName& name) const { return XXH3_64bits(&name, sizeof(name)); }
};

/// The node is not inside the cell, so that at most four corners have a weight.
NodeName NameOf(const CellNode& node, std::span<const vtkIdType> corners)
{
  NodeName name;
  std::size_t count = 0;
  for (std::size_t c = 0; c < corners.size() && count < name.corners.size(); ++c)
  {
    if (node.weight[c] == 0)
    {
      continue;
    }
    std::size_t at = count++;
    for (; at > 0 && name.corners[at - 1].point > corners[c]; --at)
    {
      name.corners[at] = name.corners[at - 1];
    }
    name.corners[at] = { corners[c], node.weight[c] };
  }
  return name;
}

/// The points of a grid. Nodes with the same name and position get a common point.
template <class Name, class Hash = std::hash<Name>>
class PointNumbering
{
public:
  explicit PointNumbering(vtkPoints* points)
    : Points(points)
  {
  }

  vtkIdType Find(const Name& name, const Vec3& x, double size)
  {
    // A name may have several positions, as for vertices of a periodic mesh, so it has a list.
    const auto [at, isNew] = First.try_emplace(name, -1);
    for (vtkIdType p = at->second; p >= 0;)
    {
      std::array<double, 3> y{};
      Points->GetPoint(p, y.data());
      if (std::max({ std::fabs(y[0] - x.x), std::fabs(y[1] - x.y), std::fabs(y[2] - x.z) }) <=
        kSamePoint * size)
      {
        return p;
      }
      const auto next = Next.find(p);
      p = next == Next.end() ? -1 : next->second;
    }
    const vtkIdType added = Points->InsertNextPoint(x.x, x.y, x.z);
    if (at->second >= 0)
    {
      Next.emplace(added, at->second);
    }
    at->second = added;
    return added;
  }

private:
  vtkPoints* Points;
  std::unordered_map<Name, vtkIdType, Hash> First;
  std::unordered_map<vtkIdType, vtkIdType> Next; ///< of points that are not the first of their name
};

template <class Function>
void ForEachInParallel(int begin, int end, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<int>(begin, end, 64),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int e = range.begin(); e < range.end(); ++e)
      {
        function(e);
      }
    });
}

/// Elements that are computed together, in parallel, before their results are stored in order.
constexpr int kTogether = 1024;

/// Calls compute(element, slot) for kTogether elements at a time, in parallel, and then
/// store(element, slot) for each in order.
template <class Compute, class Store>
void ForBatches(int elements, Compute&& compute, Store&& store)
{
  for (int begin = 0; begin < elements; begin += kTogether)
  {
    const int end = std::min(elements, begin + kTogether);
    ForEachInParallel(begin, end, [&](int e) { compute(e, static_cast<std::size_t>(e - begin)); });
    for (int e = begin; e < end; ++e)
    {
      store(e, static_cast<std::size_t>(e - begin));
    }
  }
}

/// Gives the cells' nodes their points.
class PointMaker
{
public:
  PointMaker(const SolverMesh& solver, const CellLayout& layout)
    : Solver(solver)
    , Layout(layout)
    , Points(vtkSmartPointer<vtkPoints>::New())
    , Vertices(Points)
    , Nodes(Points)
  {
    Points->SetDataTypeToDouble();
  }

  /// Sets `ids` to the points of an element's nodes, which lie at `places`.
  void Add(
    int element, const CellOfKind& kind, std::span<const Vec3> places, std::vector<vtkIdType>& ids)
  {
    const CellNodes& cell = kind.nodes;
    const auto e = static_cast<std::size_t>(element);
    ids.resize(places.size());
    if (!Layout.sharesPoints)
    {
      std::ranges::transform(places, ids.begin(),
        [this](const Vec3& x) { return Points->InsertNextPoint(x.x, x.y, x.z); });
      return;
    }
    const auto cornerCount = static_cast<std::size_t>(cell.corners);
    Corners vertices = Solver.corners[e];
    if (kind.isMirrored)
    {
      Mirror(std::span(vertices).first(cornerCount));
    }
    const double size = Solver.size[e];
    for (std::size_t k = 0; k < cornerCount; ++k)
    {
      ids[k] = Vertices.Find(vertices[k], places[k], size);
    }
    const std::vector<vtkIdType> corners(ids.begin(), ids.begin() + cell.corners);
    for (std::size_t k = cornerCount; k < places.size(); ++k)
    {
      const Vec3& x = places[k];
      ids[k] = cell.IsOnBoundary(cell.nodes[k])
        ? Nodes.Find(NameOf(cell.nodes[k], corners), x, size)
        : Points->InsertNextPoint(x.x, x.y, x.z);
    }
  }

  vtkPoints* Finish()
  {
    Points->Squeeze(); // it has grown by doubling
    return Points;
  }

private:
  const SolverMesh& Solver;
  const CellLayout& Layout;
  vtkSmartPointer<vtkPoints> Points;
  PointNumbering<std::int64_t> Vertices; ///< by the file's vertices
  PointNumbering<NodeName, NameHash> Nodes;
};

/// Stores the degrees of cells, which VTK needs where they differ by direction.
void StoreDegrees(const CellLayout& layout, vtkUnstructuredGrid* grid)
{
  const bool areUniform = std::ranges::all_of(
    layout.degrees, [](const CellDegrees& n) { return n[0] == n[1] && n[1] == n[2]; });
  if (areUniform)
  {
    return;
  }
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  degrees->SetNumberOfTuples(static_cast<vtkIdType>(layout.degrees.size()));
  for (std::size_t e = 0; e < layout.degrees.size(); ++e)
  {
    const auto& own = layout.degrees[e];
    const std::array<double, 3> tuple{ static_cast<double>(own[0]), static_cast<double>(own[1]),
      static_cast<double>(own[2]) };
    degrees->SetTypedTuple(static_cast<vtkIdType>(e), tuple.data());
  }
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
}
} // namespace

std::int64_t CellLayout::NodeCount(const Mesh& mesh) const
{
  std::map<std::pair<Shape, CellDegrees>, std::int64_t> cells;
  for (std::size_t e = 0; e < degrees.size(); ++e)
  {
    ++cells[{ mesh.ShapeOf(static_cast<int>(e)), degrees[e] }];
  }
  return std::accumulate(cells.begin(), cells.end(), std::int64_t{ 0 },
    [](std::int64_t sum, const auto& kind)
    {
      const auto& [shape, own] = kind.first;
      return sum + kind.second * static_cast<std::int64_t>(MakeCellNodes(shape, own).nodes.size());
    });
}

CellLayout CornerLayout(const Mesh& mesh)
{
  return { std::vector<CellDegrees>(static_cast<std::size_t>(mesh.Elements()), { 1, 1, 1 }) };
}

CellLayout NodeLayout(const Mesh& mesh, const std::vector<SolverField>& fields)
{
  CellLayout layout = CornerLayout(mesh);
  const auto raise = [&layout](const Expansion& values)
  {
    for (std::size_t e = 0; e < layout.degrees.size(); ++e)
    {
      const CellDegrees own = CellDegreesOf(values.SpaceOf(static_cast<int>(e)));
      std::ranges::transform(own, layout.degrees[e], layout.degrees[e].begin(),
        [](unsigned char a, unsigned char b) { return std::max(a, b); });
    }
  };
  raise(mesh.map);
  for (const SolverField& field : fields)
  {
    const Expansion values = field.values.View();
    raise(values);
    layout.sharesPoints = layout.sharesPoints && (field.continuous || IsConstantPerElement(values));
  }
  return layout;
}

void MakeCells(const SolverMesh& solver, const Mesh& mesh, const CellLayout& layout,
  const ElementCells& cells, vtkUnstructuredGrid* grid)
{
  PointMaker points(solver, layout);
  std::vector<vtkIdType> ids;
  vtkNew<vtkCellArray> connectivity;
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(mesh.Elements());
  std::vector<std::vector<Vec3>> places(kTogether);
  ForBatches(
    mesh.Elements(),
    [&](int e, std::size_t slot)
    {
      const std::vector<Vec3>& xi = cells.Of(e).xi;
      places[slot].resize(xi.size());
      MapForward(mesh, e, xi, places[slot]);
    },
    [&](int e, std::size_t slot)
    {
      points.Add(e, cells.Of(e), places[slot], ids);
      types->SetValue(e, static_cast<unsigned char>(cells.Of(e).nodes.type));
      connectivity->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    });
  connectivity->Squeeze();
  grid->SetPoints(points.Finish());
  grid->SetCells(types, connectivity);
  StoreDegrees(layout, grid);
}

bool IsConstantPerElement(const Expansion& values)
{
  return std::ranges::all_of(
    values.spaces, [](const Space& space) { return space.MaxOrder() == 0; });
}

void AddNodeValues(
  const Mesh& mesh, const Field& field, const ElementCells& cells, vtkUnstructuredGrid* grid)
{
  const int components = field.values.components;
  vtkNew<vtkDoubleArray> array;
  array->SetName(field.name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  std::vector<std::vector<double>> values(kTogether);
  ForBatches(
    mesh.Elements(),
    [&](int e, std::size_t slot)
    {
      const std::vector<Vec3>& xi = cells.Of(e).xi;
      values[slot].resize(xi.size() * static_cast<std::size_t>(components));
      EvaluateAt(mesh, field, e, xi, values[slot], {});
    },
    [&](int e, std::size_t slot)
    {
      grid->GetCells()->GetCellAtId(e, count, points);
      for (vtkIdType k = 0; k < count; ++k)
      {
        array->SetTypedTuple(points[k], &values[slot][static_cast<std::size_t>(k * components)]);
      }
    });
  grid->GetPointData()->AddArray(array);
}
} // namespace pixelexact
