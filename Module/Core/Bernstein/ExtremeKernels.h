// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

// Extremes and sums of arrays of coefficients, in as many lanes as the instruction set has; the
// same bits on each.
namespace pixelexact
{
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
} // namespace pixelexact
