// SPDX-License-Identifier: BSD-3-Clause
#ifndef FollowedGrid_h
#define FollowedGrid_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkUnstructuredGrid;

// What VTK's filters do to a grid that carries a solver's coefficients is followed where the result
// is known exactly:
//
// - Points that an affine motion moved: the map's coefficients move with them. The motion is found
//   from the elements' vertices, and all points of all cells must agree with it.
// - Points that were moved otherwise: the map is the polynomial through the cells' points, where
//   the cells have the degrees for it.
// - An array with other values than its field's: it becomes the polynomial through its values at
//   the cells' points, in place of the coefficients. So does a new array of point data.
//
// The remaining fields keep their coefficients.
namespace pixelexact
{
struct FollowedGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::vector<std::string> notes; ///< for the user, on what was not kept
};

/// Whether the grid, with coefficients that fit, has point arrays that could be fields as well.
[[nodiscard]] bool HasNewPointArrays(vtkUnstructuredGrid* grid);

/// A copy of a grid whose coefficients come from nodal values and fit, with fields of its new point
/// arrays.
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> WithNewFields(vtkUnstructuredGrid* grid);

/// A copy of a grid that carries a solver's mesh (HasSolverMesh), with coefficients that fit its
/// cells and arrays again. Throws StaleData, with the remedy, for changes that cannot be followed:
/// cells that were cut, and where the cells are linear and the elements are not, other motions than
/// affine ones and changed arrays.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT FollowedGrid FollowGrid(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
