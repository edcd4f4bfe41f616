// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/XiInverse.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// Exceeds the rounding of sums of positive bounds.
inline constexpr double kInsideUp = 1.0 + 1e-9;

/// cos(k theta_i) for n Chebyshev points of the first kind, n at most kMaxRayPoints: [k n + i].
[[nodiscard]] const std::vector<double>& RayCosines(int n);

/// Writes the n coefficients of the interpolant of values in Chebyshev's points.
void ToCoefficients(const double* values, int n, double* coefficients);

/// The sum of coefficients[k] T_k(x) of Chebyshev polynomials; there is at least one.
[[nodiscard]] double ChebyshevSum(std::span<const double> coefficients, double x);

/// An interval of x in [-1, 1] in which a point is inside a leaf, and how far its ends may be off.
struct Inside
{
  double from;
  double to;
  double fromError = 0.0;
  double toError = 0.0;
  bool isSure = true;
};

/// A linear function of s along a ray, and how far it may be off.
struct SideSeries
{
  std::array<double, kMaxRayPoints> values{};
  std::size_t count = 0;
  double error = 0.0;

  [[nodiscard]] std::span<const double> Coefficients() const
  {
    return std::span(values).first(count);
  }
};

/// Finds where all sides are >= 0 for x in [-1, 1], the interval of the series. Adds to `inside`,
/// in order. Parts in which no side is monotone enough after ten bisections are not sure.
void FindInside(const std::vector<SideSeries>& sides, std::vector<Inside>& inside);
} // namespace pixelexact
