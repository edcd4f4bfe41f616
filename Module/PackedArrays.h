// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackedArrays_h
#define PackedArrays_h

#include "PixelExactDataModelModule.h"

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

// Stores coefficients as cell arrays, so that they go where VTK takes the cells: through filters
// that append, extract, redistribute and exchange cells, to other processes, into files of pieces.
// A cell's own tuples contain all data of its element; no array depends on the number of cells.
//
// CellData, all names beginning with PixelExact.Packed., for the mesh `Mesh.` and for each field
// `Field.<name>.`:
//   Space         uint8 x 8     shape, form, three orders, Origin, Mapping, the field's place
//                               among the fields
//   Coefficients  double x W    component by component, as in Expansion; then zeros to the width W,
//                               which is that of the cell with most
//   Marks         int64 x 3     mesh: source cell, fingerprint, check. Field: components,
//                               fingerprint of the values (0: none), check
//   Sums          double        of points, or of nodal values at points (CellSums.h)
// of the mesh alone:
//   Place         double x 5    centre, size, uncertainty
//   Boundary      int32 x 2k    k attributed faces: face and attribute, -1 where there are fewer
//
// A check is the hash of all data of an unpacked element. It differs where a filter averaged,
// rounded, filled or blanked tuples.
namespace pixelexact
{
inline constexpr const char* kPackedPrefix = "PixelExact.Packed.";

/// Components of the arrays whose number depends on the data, by array. Grids can be appended where
/// these are alike.
using PackedWidths = std::map<std::string, int>;

/// Whether the grid carries packed coefficients of a mesh. Does not check whether they are
/// complete.
PIXELEXACTDATAMODEL_EXPORT bool IsPacked(vtkUnstructuredGrid* grid);

/// Names of the packed fields, in the order that they had in the grid that was packed.
PIXELEXACTDATAMODEL_EXPORT std::vector<std::string> PackedFieldNames(vtkUnstructuredGrid* grid);

/// Whether any packed cell or field has a solver's own coefficients, not coefficients from nodal
/// values.
PIXELEXACTDATAMODEL_EXPORT bool PacksSolverCoefficients(vtkUnstructuredGrid* grid);

/// The widths that packing the grid needs. Throws as HighOrderModel::From.
PIXELEXACTDATAMODEL_EXPORT PackedWidths WidthsFor(vtkUnstructuredGrid* grid);

/// The same widths for components that all have `modes` modes.
PIXELEXACTDATAMODEL_EXPORT PackedWidths WidthsForModes(vtkUnstructuredGrid* grid, int modes);

/// Raises each width to the larger one of both.
PIXELEXACTDATAMODEL_EXPORT void Widen(PackedWidths& widths, const PackedWidths& others);

/// Returns a copy of the grid that shares its arrays and has packed coefficients in place of those
/// in FieldData. Arrays are at least as wide as `atLeast`; entries of `atLeast` for fields that the
/// grid lacks are ignored. The coefficients must fit. Throws as HighOrderModel::From.
PIXELEXACTDATAMODEL_EXPORT vtkSmartPointer<vtkUnstructuredGrid> Pack(
  vtkUnstructuredGrid* grid, const PackedWidths& atLeast = {});

/// The inverse of Pack: element e is cell e. A cell counts as unchanged if its points and values at
/// points differ from those that were packed by rounding alone, as where VTK merges points.
/// HighOrderModel checks whether other cells fit. Throws InvalidData where arrays are missing, of
/// wrong type or size, or where cells of one field differ in components, origin or mapping;
/// StaleData where a check differs.
PIXELEXACTDATAMODEL_EXPORT vtkSmartPointer<vtkUnstructuredGrid> Unpack(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
