// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellStorage_h
#define CellStorage_h

#include "vtkCellArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

namespace pixelexact
{
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
} // namespace pixelexact

#endif
