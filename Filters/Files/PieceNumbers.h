// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceNumbers_h
#define PieceNumbers_h

#include "Formats/SolverModel.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkInformation;
class vtkMultiProcessController;

// The numbers that elements of a part have in the whole.
namespace pixelexact
{
/// UPDATE_PIECE_NUMBER and NUMBER_OF_PIECES of what is asked for; the whole where there are none.
PieceOf PieceAskedFor(vtkInformation* asked);

/// The processes that read the parts; null where there are no others.
vtkMultiProcessController* ProcessesOf(const PieceOf& part);

/// Of a run in pieces: how many there are, and those that were read here, with their elements.
struct PieceCounts
{
  int pieces = 0; ///< 0: it is not in pieces
  std::vector<std::pair<int, std::int64_t>> elements;
};

/// For each piece that was read here, the elements of all pieces before it. Where the parts are the
/// processes of the global controller these tell each other, and all must call it; else elements
/// are counted as if there were no other pieces. `problem`, where not empty, is why this process
/// cannot go on. Throws Error, on all of them, where any cannot, so that no picture lacks a part.
std::vector<std::int64_t> ElementsBefore(
  const PieceCounts& counts, const PieceOf& part, const std::string& problem);
} // namespace pixelexact
#endif
