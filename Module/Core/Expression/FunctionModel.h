// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/ChebyshevModel.h"
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

/// Returns an operation of one argument, of the values of a model, which are in `range`. The
/// operation is interpolated at Chebyshev's points of the range; TaylorCoefficient bounds the
/// remainder. The model's error is infinite where the operation is not smooth on all of the range.
[[nodiscard]] ChebyshevModel ComposeFunction(
  Operation operation, const ChebyshevModel& f, const Interval& range, double exponent = 0.0);
} // namespace pixelexact
