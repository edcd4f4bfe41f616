// SPDX-License-Identifier: BSD-3-Clause
#ifndef Continuity_h
#define Continuity_h

#include "Core/Element/Mesh.h"
#include "PixelExactFiltersModule.h"

#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// How a field passes from element to element.
struct PIXELEXACTFILTERS_EXPORT Continuity
{
  std::int64_t comparisons = 0; ///< of values at the same place; 0: nothing is known
  double largestJump = 0.0;     ///< of any component
  double lowest = std::numeric_limits<double>::infinity(); ///< value of any component compared
  double highest = -std::numeric_limits<double>::infinity();
  double size = 0.0; ///< the largest |coefficient|, of fields without a mapping

  /// Jumps are no larger than files in single precision explain.
  [[nodiscard]] bool IsContinuous() const;
};

/// Compares each field's values where elements meet: at their vertices and the middles of their
/// edges and faces, matched by place. A hint, not a proof: it looks at these points alone, elements
/// that do not meet face to face (hanging nodes) share few of them, and of very large meshes it
/// looks at the first elements only. Parallel; values that are not finite are left out.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT std::vector<Continuity> CompareAcrossElements(
  const Mesh& mesh, std::span<const Field> fields);
} // namespace pixelexact
#endif
