// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Expression/Graph.h"
#include "Core/Math/Interval.h"

#include <cstddef>

namespace pixelexact
{
/// Encloses f^(n) / n! over `x`, n >= 1, for a smooth operation f of one argument, and for powers
/// with the given exponent, x > 0 unless the exponent is -1. Everything, -inf to inf, where f is
/// not smooth on all of `x`, and for other operations.
[[nodiscard]] Interval TaylorCoefficient(
  Operation operation, double exponent, std::size_t n, const Interval& x);

/// Encloses the values of such an operation.
[[nodiscard]] Interval ValueAt(Operation operation, double exponent, const Interval& x);
} // namespace pixelexact
