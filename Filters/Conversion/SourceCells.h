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
/// The dimension of each type among the grid's cells; negative where VTK does not know the type.
std::map<int, int> DimensionsOf(vtkUnstructuredGrid* grid);

/// The largest dimension; 3 where VTK does not know one of the types.
int HighestDimension(const std::map<int, int>& dimensions);

/// "cell 12 (vtkLagrangeWedge)"
std::string NameCell(vtkIdType cell, int type);

/// Reads a cell's type, points, degrees and rational weights from the grid. `nodes`: positions of
/// nodes in Lagrange cells. Throws InvalidData, naming the cell, for points that do not exist,
/// invalid degrees, and weights that are not positive.
CellKind KindOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type,
  std::span<const vtkIdType> points, const NodeConvention& nodes);

// From VTK 9.6 on, types and offsets may be arrays of any kind, and the functions below replace the
// old ones.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
/// The number of cell types that a grid stores. It differs from the number of cells for truncated
/// files.
inline vtkIdType CellTypeCount(vtkUnstructuredGrid& grid)
{
  return grid.GetCellTypes()->GetNumberOfTuples();
}
/// The point ids of cells that are stored with 64 bits, one cell after the other.
inline auto* PointIds64(vtkCellArray& cells)
{
  return cells.GetConnectivityAOSArray64();
}
/// The offset of each of these cells in the point ids, and the end of the last one.
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

/// Throws InvalidData where a grid from a file contradicts itself: point ids out of range, or
/// arrays whose length differs from that of their data set. Reading such a grid later would be out
/// of bounds.
PIXELEXACTFILTERS_EXPORT void CheckConsistency(vtkUnstructuredGrid& grid);
} // namespace pixelexact
#endif
