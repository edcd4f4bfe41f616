// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartExchange_h
#define PartExchange_h

#include "Formats/SolverModel.h"
#include "PackedArrays.h"
#include "PixelExactFiltersModule.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkInformation;

// Exchange of elements between processes. All processes must call these functions.

namespace pixelexact
{
/// Throws Error on all processes where `problem` is not empty on any, with the first one's text.
PIXELEXACTFILTERS_EXPORT void AgreeThatAllIsWell(
  const std::string& problem, vtkMultiProcessController* processes);

/// Packs some cells of a grid with coefficients; empty where there are none. `fields`: whether
/// fields are packed.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> PackedCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, bool fields);

/// The packed grids of all processes, in their order; those without cells are empty.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAll(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// The same on the first process; none on others.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAllToFirst(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// Appends packed grids without the empty ones; null where all are empty.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> Appended(
  const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& packed);

/// The largest number of each name over all processes. All processes must call it.
template <class Number>
std::map<std::string, Number> LargestOfAll(
  const std::map<std::string, Number>& own, vtkMultiProcessController* processes)
{
  using Numbers = std::map<std::string, Number>;
  const auto write = [](const Numbers& numbers)
  {
    vtkMultiProcessStream stream;
    stream << static_cast<int>(numbers.size());
    for (const auto& [name, number] : numbers)
    {
      stream << name << number;
    }
    return stream;
  };
  Numbers largest;
  const auto join = [&largest](vtkMultiProcessStream& stream)
  {
    int count = 0;
    stream >> count;
    for (int i = 0; i < count; ++i)
    {
      std::string name;
      Number number = 0;
      stream >> name >> number;
      const auto [at, isNew] = largest.try_emplace(name, number);
      at->second = std::max(at->second, number);
    }
  };
  std::vector<vtkMultiProcessStream> received;
  processes->Gather(write(own), received, 0);
  for (vtkMultiProcessStream& stream : received)
  {
    join(stream);
  }
  vtkMultiProcessStream all = write(largest);
  processes->Broadcast(all, 0);
  join(all);
  return largest;
}

/// The largest widths of all processes, which must all call it. Returns `own` where there is no
/// controller or one process.
PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller);

// Numbers of a part's elements in the whole mesh. The first two functions exchange nothing, so a
// process may call them alone.

/// UPDATE_PIECE_NUMBER and NUMBER_OF_PIECES of a request; the whole where there are none.
PieceOf PieceAskedFor(vtkInformation* asked);

/// The processes that read the parts; null where there are no others.
vtkMultiProcessController* ProcessesOf(const PieceOf& part);

/// The pieces of a run: their number, and those that this process read, with their elements.
struct PieceCounts
{
  int pieces = 0; ///< 0: it is not in pieces
  std::vector<std::pair<int, std::int64_t>> elements;
};

/// For each piece that this process read, the elements of all pieces before it. Where the parts are
/// the processes of the global controller, these exchange their counts, and all must call it; else
/// elements are counted as if there were no other pieces. `problem`, if not empty, states why this
/// process cannot continue. Throws Error on all processes where any cannot continue, so that no
/// picture lacks a part.
std::vector<std::int64_t> ElementsBefore(
  const PieceCounts& counts, const PieceOf& part, const std::string& problem);
} // namespace pixelexact
#endif
