// SPDX-License-Identifier: BSD-3-Clause
#ifndef WarpedGrid_h
#define WarpedGrid_h

#include "Conversion/Displacement.h"

#include "vtkSmartPointer.h"

namespace pixelexact
{
struct WarpedGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  /// Names of H(curl), H(div) and density fields, which are left out: their values depend on the
  /// map and would change.
  std::vector<std::string> leftOut;
};

/// A copy of a grid that carries coefficients, with the map x + scale * u, exact up to one rounding
/// of each coefficient, and points that have moved with it. All other fields are the same functions
/// of xi; their arrays are shared. Throws as DisplacementOf and WarpedMesh, and InvalidData for a
/// scale that is not finite.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT WarpedGrid WarpGrid(
  vtkUnstructuredGrid* grid, const WarpRequest& request);
} // namespace pixelexact
#endif
