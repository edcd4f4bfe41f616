// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceCells_h
#define SourceCells_h

#include "Cells/CellBasis.h"
#include "PixelExactFiltersModule.h"

#include "vtkCellArray.h"
#include "vtkType.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <map>
#include <span>
#include <string>

namespace pixelexact
{
/// Of each type of the grid's cells; negative where VTK does not know the type.
std::map<int, int> DimensionsOf(vtkUnstructuredGrid* grid);

/// 3 where there is a type that VTK does not know.
int HighestDimension(const std::map<int, int>& dimensions);

/// "cell 12 (vtkLagrangeWedge)"
std::string NameCell(vtkIdType cell, int type);

/// What the grid says of a cell: its type, points, degrees and rational weights. Throws
/// InvalidData, naming the cell, for a point that is not there, degrees that are none, and weights
/// that are not positive. `nodes`: where those of a Lagrange cell stand.
CellKind KindOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type,
  std::span<const vtkIdType> points, const NodeConvention& nodes);

// From VTK 9.6 on types and offsets may be any arrays, and those of old have other names.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
/// How many types of cells a grid holds; of an incomplete file not as many as cells.
inline vtkIdType CellTypeCount(vtkUnstructuredGrid& grid)
{
  return grid.GetCellTypes()->GetNumberOfTuples();
}
/// The points of cells that are stored with 64 bits, one cell after the other.
inline auto* PointIds64(vtkCellArray& cells)
{
  return cells.GetConnectivityAOSArray64();
}
/// Where each of these cells begins among them, and where the last one ends.
inline auto* Offsets64(vtkCellArray& cells)
{
  return cells.GetOffsetsAOSArray64();
}
#else
inline vtkIdType CellTypeCount(vtkUnstructuredGrid& grid)
{
  return grid.GetCellTypesArray()->GetNumberOfTuples();
}
inline auto* PointIds64(vtkCellArray& cells)
{
  return cells.GetConnectivityArray64();
}
inline auto* Offsets64(vtkCellArray& cells)
{
  return cells.GetOffsetsArray64();
}
#endif

/// Throws InvalidData where a grid that came from a file contradicts itself: cells that point
/// beyond the points, or arrays of other lengths than their data set's, would be read out of bounds
/// later.
PIXELEXACTFILTERS_EXPORT void CheckConsistency(vtkUnstructuredGrid& grid);
} // namespace pixelexact
#endif
