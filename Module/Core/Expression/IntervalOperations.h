// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"
#include "Core/Math/Interval.h"

#include <algorithm>
#include <span>

namespace pixelexact
{
/// An enclosure of a node's value: it is in the interval, or NaN.
struct KnownInterval
{
  Interval value{ 0.0 };
  /// True wherever the interval is not finite: where a function is not defined on all of its
  /// argument, the interval is -inf to inf.
  bool mayBeNaN = false;
};

/// a + b and a b, not below 0 where neither is negative: rounding outwards alone would leave sums
/// of squares without a root.
[[nodiscard]] inline Interval SumOf(const Interval& a, const Interval& b)
{
  const Interval sum = a + b;
  return a.lower >= 0.0 && b.lower >= 0.0 ? Interval(std::max(sum.lower, 0.0), sum.upper) : sum;
}
[[nodiscard]] inline Interval ProductOf(const Interval& a, const Interval& b)
{
  const Interval product = a * b;
  return a.lower >= 0.0 && b.lower >= 0.0 ? Interval(std::max(product.lower, 0.0), product.upper)
                                          : product;
}

/// Encloses the values of an operation of one argument. Arithmetic is rounded outwards. Functions
/// of the C library (sin, exp, pow, ...) are assumed to be off by 16 units in the last place at
/// most (glibc states 1 to 4). Everything, -inf to inf, where the function is not defined on all of
/// `a`.
[[nodiscard]] Interval FunctionOf(Operation operation, const Interval& a);

/// Encloses the values of the derivative of such an operation; -inf to inf where it is not known.
[[nodiscard]] Interval SlopeOf(Operation operation, const Interval& a);

/// Encloses the values of any operation with arguments, NaN included.
[[nodiscard]] KnownInterval ApplyToIntervals(
  const Graph::Node& node, std::span<const KnownInterval> arguments);
} // namespace pixelexact
