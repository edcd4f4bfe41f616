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

/// Reads .vtu files, also those that .pvtu files name, and appends them without merging points, so
/// that discontinuous fields stay discontinuous. Rules for several parts:
///
/// - cells that another part also holds (ghosts marked as duplicates) are left out;
/// - parts without volume cells are left out (with `surfaces`: without surface elements), and so
///   are arrays that differ in kind or are missing
///   in other parts; both are noted;
/// - coefficients converted from nodal values are dropped, because the converter creates them
///   again; those of a solver's own file are joined where all parts have them, and refused
///   (Unsupported) where some have not, because they would be lost.
///
/// Each warning of VTK's reader is noted once. Throws Error, naming the file.
///
/// `share`: the share of one process of several. Of several files a process reads consecutive ones;
/// a single file is read whole and cut. Cells then have their numbers in the whole in CellData
/// kSourceCells (SourceMesh.h). Calls ElementsBefore (PartExchange.h), so all processes must call
/// it. A process without a file gets an empty grid.
PIXELEXACTFILTERS_EXPORT ReadGrid ReadParts(
  const std::vector<GridPart>& parts, const PieceOf& share = {}, bool surfaces = false);
} // namespace pixelexact
#endif
