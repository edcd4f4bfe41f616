// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/MeshRanges.h"

#include <vector>

namespace pixelexact
{
/// The proven sign of an element's det J by xi, which is regular at collapsed vertices, so that
/// these need no exception. After A. Johnen, J.-F. Remacle, C. Geuzaine, Geometrical validity of
/// curvilinear finite elements, Journal of Computational Physics 233, 2013.
enum class [[nodiscard]] Validity : std::uint8_t{
  Valid = 0,    ///< positive everywhere: the map does not fold
  Inverted = 1, ///< not positive at some point; also where it is negative everywhere
  Undecided = 2 ///< neither: zero within rounding somewhere, or the budget was spent
};
const char* Name(Validity validity);

struct ElementValidity
{
  Validity validity = Validity::Undecided;
  CertifiedRange jacobian; ///< in world units, as far as it was found on the way; never `met`
};

/// The verdict on one element of a valid mesh, in at most effort.boxes boxes; the tolerance does
/// not matter. An element whose det J vanishes somewhere within rounding stays undecided, unless it
/// is not positive elsewhere.
ElementValidity ValidityOf(const Mesh& mesh, int element, const RangeEffort& effort = {});

/// The verdicts on all elements. Parallel; the result is independent of the number of threads.
std::vector<ElementValidity> ValidityOf(
  const Mesh& mesh, const RangeEffort& effort, const RangeProgress& progress = {});
} // namespace pixelexact
