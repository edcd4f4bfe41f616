// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>

// Sweeps over arrays of coefficients, in as many lanes as the instruction set has; the same bits on
// each.
namespace pixelexact
{
/// Replaces tensor-product Bernstein coefficients of the given degree by those over a part of
/// direction d: first, where `from` > 0, over [from, 1]; then, where `rest` < 1, over [0, rest] of
/// that (de Casteljau).
void SweepTo(const std::array<int, 3>& degree, int direction, double from, double rest,
  std::span<double> bernstein);

/// values[i] -= shift.
void Subtract(double shift, std::span<double> values);

/// to[j * from.size() + i] += factors[j] from[i].
void AddOuter(std::span<const double> factors, std::span<const double> from, double* to);

/// to[i] = the sum of factors[r] rows[r][i].
void Combine(std::span<const double> factors, const double* const* rows, std::span<double> to);
} // namespace pixelexact
