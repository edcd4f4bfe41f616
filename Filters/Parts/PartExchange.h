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

// Elements from process to process. What is called here all processes must call.

namespace pixelexact
{
/// Throws Error on all processes where `problem` is not empty on any: the first one's.
PIXELEXACTFILTERS_EXPORT void AgreeThatAllIsWell(
  const std::string& problem, vtkMultiProcessController* processes);

/// Some cells of a grid with coefficients, packed; empty where there are none. `fields`: with
/// these.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> PackedCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, bool fields);

/// The packed grids of all processes, in their order; those without cells are empty.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAll(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// The same, of the first process alone; none on others.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAllToFirst(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// Packed grids one after the other, without the empty ones; null where all are.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> Appended(
  const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& packed);

/// By name the largest numbers of all processes, which all must call it.
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
  vtkMultiProcessStream told = write(largest);
  processes->Broadcast(told, 0);
  join(told);
  return largest;
}

/// The largest widths of all processes, which all must call it; those given where there is no
/// controller, or one process.
PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller);

// The numbers that elements of a part have in the whole. The first two functions are no exchange: a
// process may call them alone.

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
