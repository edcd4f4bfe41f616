// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

// Sums and extremes of several functions' coefficients that lie side by side, in as many lanes as
// the instruction set has; the same bits on each.
namespace pixelexact
{
/// Combines rows in blocks of `count` rows of `stride` numbers, to `made` rows each: row k of a
/// block becomes the sum of factors[k count + j] times its row j.
void CombineRows(std::span<const double> factors, std::size_t made, std::size_t count,
  std::size_t stride, std::span<const double> from, std::span<double> to);

/// The least and the most of the numbers k, k + count, k + 2 count, ...: of finite ones.
void ExtremesOfEach(
  std::span<const double> values, std::span<double> least, std::span<double> most);

/// The same for the numbers minus an affine function: number c of row r minus the sum of
/// slopes[d][c] times places[r][d]. Rows are `stride` apart, and as long as the results.
void ExtremesBesideAffine(std::span<const double> values, std::size_t stride,
  std::span<const Vec3> places, const std::array<std::vector<double>, 3>& slopes,
  std::span<double> least, std::span<double> most);
} // namespace pixelexact
