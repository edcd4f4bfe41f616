// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"

#include <vector>

namespace pixelexact
{
/// The basis that a solver uses on one kind of element, and its way into the canonical one. Source
/// coefficients are in the solver's local order.
struct ElementBasis
{
  /// One part: functions with scalar values, each component of a field has `sources` coefficients
  /// of its own. Three parts: functions with vector values (H(curl), H(div)); part d takes the same
  /// `sources` coefficients to component d in reference space (xi, not the solver's unit element).
  std::vector<ChangeOfBasis> parts;
  int sources = 0;

  [[nodiscard]] const Space& GetSpace() const { return parts.front().Target(); }
  [[nodiscard]] bool IsVector() const { return parts.size() == 3; }
};
} // namespace pixelexact
