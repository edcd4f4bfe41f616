// SPDX-License-Identifier: BSD-3-Clause
#include "ConversionLoss.h"

#include "HighOrderArrays.h"
#include "PackedCheck.h"
#include "PackedNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
bool HasArray(vtkDataSetAttributes* data, const std::string& name)
{
  return data->GetArray(name.c_str()) != nullptr;
}

/// The largest degree of a Lagrange cell, from its HigherOrderDegrees or its number of points.
int LagrangeDegree(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const vtkIdType points = grid->GetCells()->GetCellSize(cell);
  if (vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
      degrees != nullptr && grid->GetCellType(cell) != VTK_LAGRANGE_TETRAHEDRON)
  {
    return static_cast<int>(std::max({ degrees->GetComponent(cell, 0),
      degrees->GetComponent(cell, 1), degrees->GetComponent(cell, 2) }));
  }
  const auto pointsOf = [type = grid->GetCellType(cell)](vtkIdType n)
  {
    return type == VTK_LAGRANGE_TETRAHEDRON ? (n + 1) * (n + 2) * (n + 3) / 6
      : type == VTK_LAGRANGE_WEDGE          ? (n + 1) * (n + 1) * (n + 2) / 2
                                            : (n + 1) * (n + 1) * (n + 1);
  };
  int degree = 1;
  while (pointsOf(degree) < points)
  {
    ++degree;
  }
  return degree;
}

/// True for Lagrange cells of solid shapes.
bool IsLagrange(int cellType)
{
  return cellType == VTK_LAGRANGE_HEXAHEDRON || cellType == VTK_LAGRANGE_WEDGE ||
    cellType == VTK_LAGRANGE_TETRAHEDRON;
}

/// Which orders of an expansion the cells and the values beside them hold.
class HeldOrders
{
public:
  /// Takes the map if the name is empty, else the field with this name, origin and mapping.
  HeldOrders(vtkUnstructuredGrid* grid, const std::string& name, Origin origin, Mapping mapping)
    : Grid(grid)
    , IsFromSolver(IsSolvers(origin))
  {
    const bool isOld = origin == Origin::Coefficients; // which array shows the field is not stored
    const bool atPoints =
      name.empty() || (isOld ? HasArray(grid->GetPointData(), name) : IsAtPoints(origin));
    const bool isShown = name.empty() ||
      (atPoints ? HasArray(grid->GetPointData(), name) : HasArray(grid->GetCellData(), name));
    // Values at points are not enough for a field whose values follow the map's derivatives.
    Values = !isShown                ? Shown::Nowhere
      : mapping != Mapping::Identity ? Shown::Mapped
      : atPoints                     ? Shown::AtPoints
                                     : Shown::PerCell;
  }

  /// The order where a cell loses it, else -1.
  [[nodiscard]] int Lost(vtkIdType cell, int order) const
  {
    const int type = Grid->GetCellType(cell);
    const bool isLagrange = IsLagrange(type);
    // Cells of other kinds, and Lagrange cells of a file, are what the expansion was made from.
    if (Values == Shown::Nowhere || (isLagrange ? !IsFromSolver : !IsLinearCell(type)))
    {
      return -1;
    }
    const int held = Values == Shown::Mapped ? -1
      : Values == Shown::PerCell             ? 0
      : isLagrange                           ? LagrangeDegree(Grid, cell)
                                             : 1;
    return order > held ? order : -1;
  }

private:
  enum class Shown : std::uint8_t
  {
    Nowhere,
    Mapped,
    AtPoints,
    PerCell
  };

  vtkUnstructuredGrid* Grid;
  bool IsFromSolver;
  Shown Values = Shown::Nowhere;
};

using LostOrders = std::vector<int>; ///< per cell; -1: nothing is lost

/// `orderOf(cell)` is the largest order of the expansion in the cell.
template <class OrderOf>
void AddLost(
  vtkUnstructuredGrid* grid, const HeldOrders& held, const OrderOf& orderOf, LostOrders& lost)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    int& own = lost[static_cast<std::size_t>(cell)];
    own = std::max(own, held.Lost(cell, orderOf(cell)));
  }
}

int LargestOrder(vtkDataArray* spaces, vtkIdType tuple)
{
  return static_cast<int>(std::max({ spaces->GetComponent(tuple, 2), spaces->GetComponent(tuple, 3),
    spaces->GetComponent(tuple, 4) }));
}

int FirstNumber(vtkFieldData* data, const std::string& name)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  return array != nullptr && array->GetNumberOfValues() > 0
    ? static_cast<int>(array->GetComponent(0, 0))
    : 0;
}

/// Adds the losses of an expansion stored in FieldData. Cells that do not name an element count as
/// elements of the highest order.
void AddStored(vtkUnstructuredGrid* grid, const std::string& name, LostOrders& lost)
{
  const std::string prefix = name.empty() ? kMeshPrefix : kFieldPrefix + name + ".";
  vtkFieldData* data = grid->GetFieldData();
  vtkDataArray* spaces = data->GetArray((prefix + "Spaces").c_str());
  vtkDataArray* spaceOf = data->GetArray((prefix + "Space").c_str());
  if (spaces == nullptr || spaceOf == nullptr || spaces->GetNumberOfComponents() < 5)
  {
    return;
  }
  int highest = 0;
  for (vtkIdType i = 0; i < spaces->GetNumberOfTuples(); ++i)
  {
    highest = std::max(highest, LargestOrder(spaces, i));
  }
  vtkDataArray* ids = grid->GetCellData()->GetArray(kElementIds);
  const HeldOrders held(grid, name, static_cast<Origin>(FirstNumber(data, prefix + "Origin")),
    static_cast<Mapping>(FirstNumber(data, prefix + "Mapping")));
  const auto orderOf = [&](vtkIdType cell)
  {
    const auto element = ids != nullptr ? static_cast<vtkIdType>(ids->GetComponent(cell, 0)) : -1;
    const auto space = element >= 0 && element < spaceOf->GetNumberOfTuples()
      ? static_cast<vtkIdType>(spaceOf->GetComponent(element, 0))
      : -1;
    return space >= 0 && space < spaces->GetNumberOfTuples() ? LargestOrder(spaces, space)
                                                             : highest;
  };
  AddLost(grid, held, orderOf, lost);
}

/// Adds the losses of a packed expansion.
void AddPacked(vtkUnstructuredGrid* grid, const std::string& name, LostOrders& lost)
{
  const std::string prefix = name.empty() ? packing::kMesh : packing::FieldName(name);
  vtkDataArray* spaces = grid->GetCellData()->GetArray((prefix + "Space").c_str());
  if (spaces == nullptr || spaces->GetNumberOfComponents() != kPackedSpace ||
    spaces->GetNumberOfTuples() == 0)
  {
    return;
  }
  const auto first = [spaces](int number)
  { return static_cast<int>(spaces->GetComponent(0, number)); };
  const HeldOrders held(grid, name, static_cast<Origin>(first(kPackedOrigin)),
    static_cast<Mapping>(first(kPackedOrigin + 1)));
  AddLost(
    grid, held, [&](vtkIdType cell) { return LargestOrder(spaces, cell); }, lost);
}

/// The largest value of the array kLinearizedOrder. Filters may have averaged it or moved it to
/// point data.
int LargestMark(vtkUnstructuredGrid* grid)
{
  double largest = 0.0;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
         static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    if (vtkDataArray* marks = data->GetArray(kLinearizedOrder))
    {
      largest = std::max(largest, marks->GetRange(0)[1]);
    }
  }
  return static_cast<int>(std::ceil(largest));
}
} // namespace

bool IsLinearCell(int cellType)
{
  return cellType <= VTK_HEXAGONAL_PRISM || cellType == VTK_CONVEX_POINT_SET ||
    cellType == VTK_POLYHEDRON;
}

void MarkLinearized(vtkUnstructuredGrid* grid, const std::string& name)
{
  LostOrders lost(static_cast<std::size_t>(grid->GetNumberOfCells()), -1);
  AddStored(grid, name, lost);
  if (std::ranges::all_of(lost, [](int order) { return order < 0; }))
  {
    return;
  }
  // The array is replaced, not modified, because time steps share the mesh's array.
  vtkDataArray* const before = grid->GetCellData()->GetArray(kLinearizedOrder);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(kLinearizedOrder);
  marks->SetNumberOfValues(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int order = lost[static_cast<std::size_t>(cell)];
    const int own = order < 0 ? 0 : std::max(order, 1);
    const int known = before != nullptr ? static_cast<int>(before->GetComponent(cell, 0)) : 0;
    marks->SetValue(cell, static_cast<unsigned char>(std::max(own, known)));
  }
  grid->GetCellData()->AddArray(marks);
}

int OrderLostByConversion(vtkUnstructuredGrid* grid)
{
  if (!HasHighOrderArrays(grid))
  {
    const int mark = LargestMark(grid);
    return mark > 0 ? mark : -1;
  }
  LostOrders lost(static_cast<std::size_t>(grid->GetNumberOfCells()), -1);
  const auto add = IsPacked(grid) ? &AddPacked : &AddStored;
  add(grid, "", lost);
  for (const std::string& name : StoredFieldNames(grid))
  {
    add(grid, name, lost);
  }
  const auto highest = std::ranges::max_element(lost);
  return highest == lost.end() ? -1 : *highest;
}

bool CellsHoldMap(vtkUnstructuredGrid* grid)
{
  LostOrders lost(static_cast<std::size_t>(grid->GetNumberOfCells()), -1);
  AddStored(grid, "", lost);
  return std::ranges::all_of(lost, [](int order) { return order < 0; });
}

std::string RemedyOf(vtkUnstructuredGrid* grid)
{
  if (const int order = OrderLostByConversion(grid); order >= 0)
  {
    return "; its cells are linear, so that a conversion would lose what has order " +
      std::to_string(order) +
      ": take the grid as its reader gives it, give results of filters another name, leave cells "
      "whole (Threshold, ExtractCells; vtkHighOrderPack before cells are put together), and move "
      "actors or representations, not points.";
  }
  return "; run vtkUnstructuredGridToHighOrderGrid again (in ParaView: PixelExact Convert).";
}

} // namespace pixelexact
