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
/// A grid of its own among those that are put together.
struct ReadPart
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  GridPart file;
  int number = 0; ///< of its file among all
};

/// Drops parts that a later one of the same label replaces, as where a run was continued and lists
/// a time once more: at least half of each part's cells have their centre inside the other one, by
/// samples. Parts of the same label that stand beside each other stay, and so do small ones within
/// larger ones. Adds a note for each that is dropped.
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

/// The same of marked cells alone, for one process of several, which does not have all parts. All
/// of `processes` must call it; null: nobody can be asked, and all marked cells are dropped. A note
/// is the first process's.
void DropMarkedCells(std::vector<ReadPart>& parts, vtkMultiProcessController* processes,
  std::vector<std::string>& notes);

/// Cells of a grid, in the order given, with their coefficients.
vtkSmartPointer<vtkUnstructuredGrid> KeepCells(
  vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells);
} // namespace pixelexact
#endif
