// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/BoxValue.h"

#include <span>

namespace pixelexact
{
/// A bound of the error of the double that is computed for a node at any point of a box, from those
/// of its arguments. `result` holds the exact values.
[[nodiscard]] double RoundingOf(
  const Graph::Node& node, std::span<const BoxValue> arguments, const Interval& result);
/// With the rounding of an operation itself, `own` relative to its result, beside what becomes of
/// the arguments' errors.
[[nodiscard]] double RoundedError(double propagated, double own, const Interval& result);

/// Whether a node may jump in the box.
[[nodiscard]] bool MayJump(
  const Graph::Node& node, std::span<const BoxValue> arguments, const Interval& result);
/// Of Min, Max and Select, the argument that is chosen on all of the box; null where that is not
/// known.
[[nodiscard]] const BoxValue* Chosen(const Graph::Node& node, std::span<const BoxValue> arguments);
} // namespace pixelexact
