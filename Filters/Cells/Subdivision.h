// SPDX-License-Identifier: BSD-3-Clause
#ifndef Subdivision_h
#define Subdivision_h

#include "Grids/FilterWork.h"
#include "HighOrderModel.h"

#include <cstdint>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// How fine each element is cut: level l, edges into 2^l parts.
struct SubdivisionLevels
{
  std::vector<std::uint8_t> ofElement;
  std::int64_t coarse = 0; ///< elements of which the finest level still misses the tolerance
  bool aborted = false;
};

/// The same level everywhere.
[[nodiscard]] SubdivisionLevels UniformLevels(const HighOrderModel& model, int level);

/// The lowest level, at most `most`, at which linear cells are off by no more than `tolerance`: in
/// place, over the diagonal of the mesh's box, and in the values of `fields`, over their ranges at
/// nodes of level 1. Classified at the middles of edges and of cells (of pyramids, of their bases):
/// by samples, which prove nothing.
[[nodiscard]] SubdivisionLevels AdaptedLevels(const HighOrderModel& model,
  const std::vector<const Field*>& fields, double tolerance, int most,
  const StepProgress& progress);

/// What the levels make: points and cells.
struct SubdivisionSize
{
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::int64_t corners = 0;
};
[[nodiscard]] SubdivisionSize SizeOf(const HighOrderModel& model, const SubdivisionLevels& levels);

/// Makes `output` the linear cells, with the fields' values at their points, the array Element (the
/// source's cell) and, per cell, the number of its element in `elementOf`. Points are shared within
/// an element, never between elements: fields may jump there. False where it was aborted.
[[nodiscard]] bool Subdivide(const HighOrderModel& model, const std::vector<const Field*>& fields,
  const SubdivisionLevels& levels, vtkUnstructuredGrid* output, std::vector<int>& elementOf,
  const StepProgress& progress);
} // namespace pixelexact
#endif
