// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridParts_h
#define GridParts_h

#include "PixelExactFiltersModule.h"
#include "TimeSeries.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace pixelexact
{
struct ReadGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::vector<std::string> notes; ///< lines for the user
};

/// Reads .vtu files, also those that .pvtu files name, and puts them together, one after the other,
/// without merging points: what is discontinuous stays so. Of several parts,
///
/// - cells that another part holds too (ghosts marked as duplicates) are left out;
/// - parts without volume cells are left out, and so are arrays that not all others have alike;
///   both are noted;
/// - coefficients that were made from nodal values are dropped (the converter makes them again);
///   those of a solver's own file, which could only be lost, are Unsupported.
///
/// Of what VTK's reader warns, each thing once, is noted too. Throws Error, naming the file.
PIXELEXACTFILTERS_EXPORT ReadGrid ReadParts(const std::vector<GridPart>& parts);
} // namespace pixelexact
#endif
