// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridParts_h
#define GridParts_h

#include "Files/TimeSeries.h"
#include "PixelExactFiltersModule.h"

#include "Formats/SolverModel.h"

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
///   those of a solver's own file are put together where all parts carry such, and Unsupported,
///   since they could only be lost, where some do not.
///
/// Of what VTK's reader warns, each thing once, is noted too. Throws Error, naming the file.
///
/// For one process of several, `share`: of several files some that follow each other are read, a
/// single one is read whole and cut. Cells then have the numbers of the
/// whole in CellData kSourceCells (SourceMesh.h); see ElementsBefore (PartExchange.h), which is
/// called. A process without a file has an empty grid.
PIXELEXACTFILTERS_EXPORT ReadGrid ReadParts(
  const std::vector<GridPart>& parts, const PieceOf& share = {});
} // namespace pixelexact
#endif
