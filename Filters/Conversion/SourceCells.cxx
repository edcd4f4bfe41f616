// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SourceCells.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

namespace pixelexact
{
namespace
{
std::array<int, 3> GivenDegrees(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
  if (!degrees || degrees->GetNumberOfComponents() != 3)
  {
    return { 0, 0, 0 };
  }
  std::array<int, 3> n{};
  for (int d = 0; d < 3; ++d)
  {
    const double value = degrees->GetComponent(cell, d);
    if (!(value >= 0.0 && value <= kMaxOrder && value == std::floor(value)))
    {
      throw InvalidData(NameCell(cell, grid->GetCellType(cell)) + " has HigherOrderDegrees of " +
        std::to_string(value) + ", no whole number from 1 to " + std::to_string(kMaxOrder) +
        "; correct that cell array.");
    }
    n[d] = static_cast<int>(value);
  }
  return n;
}

bool IsSimplex(int type)
{
  return type == VTK_LAGRANGE_TETRAHEDRON || type == VTK_BEZIER_TETRAHEDRON ||
    type == VTK_LAGRANGE_TRIANGLE || type == VTK_BEZIER_TRIANGLE;
}

/// Whether the rational weights of these points are equal. A Bezier cell with equal weights is
/// polynomial.
bool HasEqualWeights(vtkUnstructuredGrid* grid, std::span<const vtkIdType> points)
{
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  if (!weights || points.empty())
  {
    return true;
  }
  const double first = weights->GetComponent(points[0], 0);
  return first != 0.0 && std::isfinite(first) &&
    std::ranges::all_of(points, [&](vtkIdType p) { return weights->GetComponent(p, 0) == first; });
}

/// Hashes a cell's weights. Throws InvalidData for weights that are not positive.
std::uint64_t HashWeights(
  vtkUnstructuredGrid* grid, vtkIdType cell, int type, std::span<const vtkIdType> points)
{
  vtkDataArray* weights = grid->GetPointData()->GetRationalWeights();
  std::string bytes;
  for (const auto p : points)
  {
    const double weight = weights->GetComponent(p, 0);
    if (!(weight > 0.0) || !std::isfinite(weight))
    {
      throw InvalidData(NameCell(cell, type) + " has the rational weight " +
        std::to_string(weight) + "; weights must be positive: refit the cell.");
    }
    bytes.append(reinterpret_cast<const char*>(&weight), sizeof weight);
  }
  return std::max<std::uint64_t>(std::hash<std::string>()(bytes), 1);
}
} // namespace

std::map<int, int> DimensionsOf(vtkUnstructuredGrid* grid)
{
  std::map<int, int> dimensions;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const auto [known, isNew] = dimensions.try_emplace(type);
    if (isNew)
    {
      known->second = CellDimension(type);
    }
  }
  return dimensions;
}

int HighestDimension(const std::map<int, int>& dimensions)
{
  int highest = 0;
  for (const auto& [type, dimension] : dimensions)
  {
    highest = std::max(highest, dimension < 0 ? 3 : dimension);
  }
  return highest;
}

std::string NameCell(vtkIdType cell, int type)
{
  return "cell " + std::to_string(cell) + " (" + CellTypeName(type) + ")";
}

CellKind KindOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type,
  std::span<const vtkIdType> points, const NodeConvention& nodes)
{
  for (const auto id : points)
  {
    if (id < 0 || id >= grid->GetNumberOfPoints())
    {
      throw InvalidData(NameCell(cell, type) + " names point " + std::to_string(id) + " of " +
        std::to_string(grid->GetNumberOfPoints()) + "; the file's connectivity is damaged.");
    }
  }
  CellKind kind{ type, static_cast<int>(points.size()), { 0, 0, 0 },
    IsLagrangeCell(type) ? nodes : NodeConvention() };
  if (IsHigherOrderCell(type) || IsHigherOrderPlaneCell(type))
  {
    // The number of points determines a simplex's order.
    if (!IsSimplex(type))
    {
      kind.degrees = GivenDegrees(grid, cell);
    }
    if (!IsLagrangeCell(type) && !HasEqualWeights(grid, points))
    {
      kind.weights = HashWeights(grid, cell, type, points);
    }
  }
  return kind;
}

void CheckConsistency(vtkUnstructuredGrid& grid)
{
  const vtkIdType points = grid.GetNumberOfPoints();
  const vtkIdType cells = grid.GetNumberOfCells();
  // A truncated file may leave the grid without cell arrays.
  if (vtkCellArray* connectivity = cells > 0 ? grid.GetCells() : nullptr)
  {
    if (CellTypeCount(grid) != cells)
    {
      throw InvalidData("the numbers of cells and of cell types differ");
    }
    if (!connectivity->IsValid())
    {
      throw InvalidData("the offsets of its cells do not fit their list of points");
    }
    vtkIdType cell = 0;
    const auto iterator = vtk::TakeSmartPointer(connectivity->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
         iterator->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      if (std::any_of(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; }))
      {
        throw InvalidData(
          "cell " + std::to_string(cell) + " has a point that the file does not hold");
      }
    }
  }
  const auto checkArrays = [](vtkDataSetAttributes& data, vtkIdType expected, const char* what)
  {
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      const vtkAbstractArray* array = data.GetAbstractArray(i);
      if (array->GetNumberOfTuples() != expected)
      {
        const char* name = data.GetArrayName(i);
        throw InvalidData(std::string(what) + " array '" + (name != nullptr ? name : "") +
          "' holds " + Counted(array->GetNumberOfTuples(), "value") + " for " +
          Counted(expected, what));
      }
    }
  };
  checkArrays(*grid.GetPointData(), points, "point");
  checkArrays(*grid.GetCellData(), cells, "cell");
}
} // namespace pixelexact
