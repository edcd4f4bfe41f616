// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceCells_h
#define SourceCells_h

#include "Cells/CellBasis.h"

#include "vtkType.h"

#include <map>
#include <span>
#include <string>

class vtkUnstructuredGrid;

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
} // namespace pixelexact
#endif
