// SPDX-License-Identifier: BSD-3-Clause
#ifndef ConversionLoss_h
#define ConversionLoss_h

#include "PixelExactDataModelModule.h"

#include <string>

class vtkUnstructuredGrid;

// Measures what a conversion of a grid's cells and their point or cell values would lose of the
// coefficients that the grid carries. A solver's own grid has linear cells, and so have cells that
// filters cut out of curved ones. Messages advise a conversion only where nothing is lost, and the
// converter refuses others.
namespace pixelexact
{
/// CellData, uint8, of a solver's grid: the highest order of the element's map and fields that its
/// linear cell and point or cell values do not represent, at least 1; 0: they represent all. The
/// array remains where a filter drops FieldData with the coefficients.
inline constexpr const char* kLinearizedOrder = "PixelExactLinearizedOrder";

/// True for VTK's cells of degree 1, and for cells without a degree (polyhedra).
PIXELEXACTDATAMODEL_EXPORT bool IsLinearCell(int cellType);

/// Adds to kLinearizedOrder what the cells do not hold of the map (empty name) or field just
/// stored.
PIXELEXACTDATAMODEL_EXPORT void MarkLinearized(vtkUnstructuredGrid* grid, const std::string& name);

/// The highest order of a map or field of `grid` that a conversion would lose, because the cells
/// are VTK's linear ones; -1 where it would lose none. Coefficients may be packed or not, fit the
/// cells or not, or be lost (kLinearizedOrder). Fields that no array shows do not count: a
/// conversion leaves them out.
PIXELEXACTDATAMODEL_EXPORT int OrderLostByConversion(vtkUnstructuredGrid* grid);

/// Whether the cells hold the map of coefficients that are not packed, so that a conversion of the
/// points would lose nothing of it.
PIXELEXACTDATAMODEL_EXPORT bool CellsHoldMap(vtkUnstructuredGrid* grid);

/// The end of a message on coefficients that do not fit: what a user can do. Begins with "; ".
PIXELEXACTDATAMODEL_EXPORT std::string RemedyOf(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
