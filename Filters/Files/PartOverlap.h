// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartOverlap_h
#define PartOverlap_h

#include "Files/TimeSeries.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <span>
#include <string>
#include <vector>

class vtkMultiProcessController;

// Parts of a grid that overlap: each cell is to count once.
namespace pixelexact
{
/// A part with its own grid.
struct ReadPart
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  GridPart file;
  int number = 0; ///< of its file among all
};

/// Drops parts that a later part with the same label replaces, as in a continued run that lists a
/// time again: at least half of each part's cells have their centre inside the other part, by
/// sampling. Parts with the same label that are disjoint stay, and so do small ones within larger
/// ones. Adds a note for each dropped part.
void DropReplacedParts(std::vector<ReadPart>& parts, std::vector<std::string>& notes);

/// Drops cells so that each counts once:
///
/// - of a cell that is marked as another part's (DUPLICATECELL) and that another part has, the
///   marked ones;
/// - of a cell that all parts mark which have it, and of which no other part has the place, all but
///   the first, which loses its mark;
/// - of a cell that several parts have without a mark, all but the last.
///
/// Notes say how many cells were of the last two kinds. The parts' solver coefficients stay with
/// the cells that are kept.
void DropSharedCells(std::vector<ReadPart>& parts, std::vector<std::string>& notes);

/// The same for marked cells only, on one process of several, which does not have all parts. All of
/// `processes` must call it; null: no other process is available, and all marked cells are dropped.
/// The first process adds a note.
void DropMarkedCells(std::vector<ReadPart>& parts, vtkMultiProcessController* processes,
  std::vector<std::string>& notes);

/// Cells of a grid, in the order given, with their coefficients.
vtkSmartPointer<vtkUnstructuredGrid> KeepCells(
  vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells);
} // namespace pixelexact
#endif
