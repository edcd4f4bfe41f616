// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Rounding.h"
#include "Core/Math/Vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

// What bounds along edges are reckoned with: sums and products that are not negative.
namespace pixelexact::edges
{
/// Covers the rounding of some dozen of them.
inline constexpr double kUp = 1.0 + 1e-13;
/// The same, as a part of the largest.
inline constexpr double kRoundoffs = 32.0 * kUnitRoundoff;
/// By how much a path may leave the element, in xi: far less than would be seen, and more than
/// rounding makes of an edge in a face.
inline constexpr double kBeside = 1e-13;
/// Of symmetric matrices: 11, 12, 13, 22, 23, 33.
inline constexpr std::size_t kRows[6] = { 0, 0, 0, 1, 1, 2 };
inline constexpr std::size_t kColumns[6] = { 0, 1, 2, 1, 2, 2 };

inline double LargestOf(const Vec3& a)
{
  return std::max({ std::fabs(a.x), std::fabs(a.y), std::fabs(a.z) });
}

inline double SumOf(const Vec3& a)
{
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

/// sum of m_ij s_i s_j.
inline double Quadratic(const double (&m)[6], const double (&s)[3])
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
  {
    sum += m[k] * s[kRows[k]] * s[kColumns[k]];
  }
  return sum;
}

/// sum of m_ij s_i t_j.
inline double Bilinear(const double (&m)[6], const double (&s)[3], const double (&t)[3])
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
  {
    sum += 0.5 * m[k] * (s[kRows[k]] * t[kColumns[k]] + s[kColumns[k]] * t[kRows[k]]);
  }
  return sum;
}

/// Bounds of the solution of (I + E) v = w from those of w.
inline void Solve(const double (&turn)[3], double (&v)[3])
{
  const double largest = std::max({ v[0], v[1], v[2] });
  const double most = std::max({ turn[0], turn[1], turn[2] });
  for (std::size_t k = 0; k < 3; ++k)
  {
    v[k] = (v[k] + turn[k] * largest / (1.0 - most)) * kUp;
  }
}
} // namespace pixelexact::edges
