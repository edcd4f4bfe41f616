// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

// Extremes and sums of arrays of coefficients, in as many lanes as the instruction set has. The
// bits do not depend on the instruction set.
namespace pixelexact
{
/// The smallest and the largest of some numbers.
struct NumberExtremes
{
  double least;
  double most;
  bool finite; ///< all of them; else the others mean nothing
};
NumberExtremes ExtremesOf(std::span<const double> values);

/// The largest magnitude of the first or second differences (order 1 or 2) of numbers that lie
/// `stride` apart, in blocks of `block` numbers each. Differences that are NaN are ignored.
double LargestDifference(
  std::span<const double> values, std::size_t stride, std::size_t block, int order);

/// The smallest and the largest first difference of numbers that lie `stride` apart, in blocks of
/// `block` numbers each.
NumberExtremes DifferencesOf(std::span<const double> values, std::size_t stride, std::size_t block);

/// The smallest and the largest number of each slice across a direction: number i of a block of
/// `block` numbers is in slice i / stride. Returns false where a number is not finite; the results
/// are then undefined.
bool ExtremesAlong(std::span<const double> values, std::size_t stride, std::size_t block,
  std::span<double> least, std::span<double> most);

/// The sum of |values[i]| weights[i], up to the rounding of values.size() / 8 + 8 sums.
double WeighMagnitudes(std::span<const double> values, const double* weights);
} // namespace pixelexact
