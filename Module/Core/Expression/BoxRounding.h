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
/// Adds the rounding of an operation itself, `own` relative to its result, to the propagated errors
/// of the arguments.
[[nodiscard]] inline double RoundedError(double propagated, double own, const Interval& result)
{
  // Covers the rounding of the bound itself.
  constexpr double kAbove = 1.0 + 0x1p-40;
  const double error = (propagated + own * (result.Magnitude() + propagated)) * kAbove + 0x1p-1060;
  // The comparison is written so that a NaN is not a bound.
  return error >= 0.0 ? error : kInfinity;
}

/// Whether a node may jump in the box.
[[nodiscard]] bool MayJump(
  const Graph::Node& node, std::span<const BoxValue> arguments, const Interval& result);
/// The argument of Min, Max or Select that is chosen on all of the box; null where that is not
/// known.
[[nodiscard]] const BoxValue* Chosen(const Graph::Node& node, std::span<const BoxValue> arguments);
} // namespace pixelexact
