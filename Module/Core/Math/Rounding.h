// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

namespace pixelexact
{
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Unit roundoff of double, round to nearest: 2^-53.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// gamma_n = n u / (1 - n u), rounded up: the relative error of n chained roundings
/// (N. Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 3.1).
constexpr double Gamma(int n)
{
  const double nu = n * kUnitRoundoff;
  return nu / (1.0 - nu) * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
}

/// Exceeds by far what underflow loses in sums and products of normal numbers.
inline constexpr double kUnderflow = 0x1p-1000;

inline double NextUp(double v)
{
  return std::nextafter(v, std::numeric_limits<double>::infinity());
}
inline double NextDown(double v)
{
  return std::nextafter(v, -std::numeric_limits<double>::infinity());
}

/// The smallest float not below v.
inline float FloatUp(double v)
{
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) >= v ? f
                                     : std::nextafter(f, std::numeric_limits<float>::infinity());
}
/// The largest float not above v.
inline float FloatDown(double v)
{
  const auto f = static_cast<float>(v);
  return static_cast<double>(f) <= v ? f
                                     : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
} // namespace pixelexact
