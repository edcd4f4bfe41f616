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

/// The least and the most of some numbers.
struct Extremes
{
  double least;
  double most;
  bool finite; ///< all of them; else the others mean nothing
};
Extremes ExtremesOf(std::span<const double> values);

/// The largest magnitude of differences of numbers that lie `stride` apart, the first or the second
/// ones (order 1 or 2), of blocks of `block` numbers each. Those that are no numbers do not count.
double LargestDifference(
  std::span<const double> values, std::size_t stride, std::size_t block, int order);

/// Of first differences of numbers that lie `stride` apart, in blocks of `block` numbers each.
Extremes DifferencesOf(std::span<const double> values, std::size_t stride, std::size_t block);

/// Of each slice of numbers across a direction: number i of a block of `block` numbers is in slice
/// i / stride. False where a number is not finite; the others then mean nothing.
bool ExtremesAlong(std::span<const double> values, std::size_t stride, std::size_t block,
  std::span<double> least, std::span<double> most);

/// The sum of |values[i]| weights[i], up to the rounding of values.size() / 8 + 8 sums.
double WeighMagnitudes(std::span<const double> values, const double* weights);

/// values[i] -= shift.
void Subtract(double shift, std::span<double> values);

/// to[j * from.size() + i] += factors[j] from[i].
void AddOuter(std::span<const double> factors, std::span<const double> from, double* to);

/// to[i] = the sum of factors[r] rows[r][i].
void Combine(std::span<const double> factors, const double* const* rows, std::span<double> to);
} // namespace pixelexact
