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
/// Subdivision level of each element. Level l divides an edge into 2^l parts.
struct SubdivisionLevels
{
  std::vector<std::uint8_t> ofElement;
  std::int64_t coarse = 0; ///< elements of which the finest level still misses the tolerance
  bool aborted = false;
};

/// The same level for all elements.
[[nodiscard]] SubdivisionLevels UniformLevels(const HighOrderModel& model, int level);

/// The lowest level, at most `most`, at which linear cells differ by at most `tolerance` in
/// position, relative to the diagonal of the mesh's box, and in the values of `fields`, relative to
/// their ranges at nodes of level 1. Compared at the middles of edges and cells (of pyramids: of
/// their bases). These samples prove nothing.
[[nodiscard]] SubdivisionLevels AdaptedLevels(const HighOrderModel& model,
  const std::vector<const Field*>& fields, double tolerance, int most,
  const StepProgress& progress);

/// Numbers of points, cells and corners at given levels.
struct SubdivisionSize
{
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::int64_t corners = 0;
};
[[nodiscard]] SubdivisionSize SizeOf(const HighOrderModel& model, const SubdivisionLevels& levels);

/// Fills `output` with the linear cells, the fields' values at their points, and the array Element
/// (the source's cell); `elementOf` gets each cell's element. Points are shared within an element
/// and never between elements, because fields may jump there. Returns false where it was aborted.
[[nodiscard]] bool Subdivide(const HighOrderModel& model, const std::vector<const Field*>& fields,
  const SubdivisionLevels& levels, vtkUnstructuredGrid* output, std::vector<int>& elementOf,
  const StepProgress& progress);
} // namespace pixelexact
#endif
