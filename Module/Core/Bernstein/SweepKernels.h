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

/// Splits tensor-product Bernstein coefficients of the given degree at the middle of direction d
/// (de Casteljau): `bernstein` becomes the lower half's, `upper` the upper half's. Rounding adds at
/// most gamma(degree[d]) max |b|. Several functions may lie one after the other. The same bits on
/// each instruction set.
void Subdivide(const std::array<int, 3>& degree, int direction, std::span<double> bernstein,
  std::span<double> upper);

// Extremes and sums of arrays of coefficients, in as many lanes as the instruction set has. The
// bits do not depend on the instruction set.

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
