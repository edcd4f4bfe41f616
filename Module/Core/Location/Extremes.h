// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/MeshRanges.h"

#include <limits>

namespace pixelexact
{
/// The minimum or the maximum of a scalar over a mesh: a place where a value is attained that is
/// next to it, and proven bounds.
struct Extreme
{
  int element = -1; ///< -1: no value is known, and all numbers are NaN
  Vec3 xi{ std::numeric_limits<double>::quiet_NaN() }; ///< in the element's reference space
  Vec3 x{ std::numeric_limits<double>::quiet_NaN() };  ///< Phi(xi), world
  /// The value at xi as EvaluateAt computes it, rounded as all values are.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// Proven: the field has no value below it (of a maximum: above it); infinite where no bound was
  /// found. It is not on the inner side of `value`.
  double bound = std::numeric_limits<double>::quiet_NaN();
  /// Proven: the field attains a value that is not above it (of a maximum: not below it), at xi up
  /// to rounding. The extreme lies between `bound` and this number.
  double attained = std::numeric_limits<double>::quiet_NaN();
  /// |attained - bound|, rounded up; never below 0.
  double gap = std::numeric_limits<double>::quiet_NaN();
};

struct Extremes
{
  Extreme minimum;
  Extreme maximum;
  int notFinite = 0;      ///< elements with a NaN or infinite coefficient, which are left out
  int unbounded = 0;      ///< elements of which no bound was found; then a bound is infinite
  bool met = false;       ///< both gaps are as small as was requested
  std::int64_t boxes = 0; ///< bounded in all
};

/// The largest gap relative to the range of values, and the largest number of boxes an element.
inline constexpr RangeEffort kExtremeEffort{ 1e-9, 20000 };

/// The extremes of a quantity (Component or Magnitude of a field) over all elements of a valid
/// mesh. Gaps are at most effort.tolerance of the range of values, or 2^-40 of the largest
/// magnitude, unless the boxes or rounding do not allow it (`met`). `isPlane`: elements are those
/// of a slab (Slab.h), and the places are in its middle. Where an extreme is attained at several
/// places, one of them is returned. Parallel; the result is independent of the number of threads.
/// Throws Unsupported as RangeOf.
Extremes FindExtremes(const Mesh& mesh, const RangeQuestion& question, bool isPlane,
  const RangeEffort& effort = kExtremeEffort, const RangeProgress& progress = {});
} // namespace pixelexact
