// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"

#include <functional>
#include <vector>

namespace pixelexact
{
/// Called with the part done, 0 to 1, by the calling thread.
using RangeProgress = std::function<void(double)>;

/// The range of a quantity over a mesh.
struct MeshRange
{
  /// The range over all elements whose coefficients are finite; lower > upper where there is none.
  CertifiedRange range;
  /// Elements that attain the ends of range.attained; -1 where there is none.
  int lowerElement = -1;
  int upperElement = -1;
  /// The points in eta (see TensorToReference) of these elements, up to rounding of the
  /// coordinates; NaN where there is none.
  Vec3 lowerPoint{ std::numeric_limits<double>::quiet_NaN() };
  Vec3 upperPoint{ std::numeric_limits<double>::quiet_NaN() };
  int notFinite = 0;      ///< elements with a NaN or infinite coefficient, of which nothing is said
  int unbounded = 0;      ///< elements of which no bound was found in the budget
  std::int64_t boxes = 0; ///< looked at in all
};

/// RangeOf for every element. Parallel; the result is independent of the number of threads.
std::vector<CertifiedRange> ElementRanges(const Mesh& mesh, const RangeQuestion& question,
  const RangeEffort& effort, const RangeProgress& progress = {});

/// The range of a quantity over all elements of a valid mesh. Elements that cannot hold the
/// extremes are visited once; the others in rounds of increasing numbers of boxes each, up to
/// effort.boxes, until the outer ends are within effort.tolerance of the attained range. Parallel;
/// the result is independent of the number of threads. Throws Unsupported as RangeOf.
MeshRange RangeOf(const Mesh& mesh, const RangeQuestion& question, const RangeEffort& effort,
  const RangeProgress& progress = {});
} // namespace pixelexact
