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
  return s[0] * (m[0] * s[0] + m[1] * s[1] + m[2] * s[2]) + s[1] * (m[3] * s[1] + m[4] * s[2]) +
    s[2] * m[5] * s[2];
}

/// sum of m_ij s_i t_j.
inline double Bilinear(const double (&m)[6], const double (&s)[3], const double (&t)[3])
{
  return m[0] * s[0] * t[0] + m[3] * s[1] * t[1] + m[5] * s[2] * t[2] +
    0.5 *
    (m[1] * (s[0] * t[1] + s[1] * t[0]) + m[2] * (s[0] * t[2] + s[2] * t[0]) +
      m[4] * (s[1] * t[2] + s[2] * t[1]));
}

/// Bounds (I - A)^-1 of A >= 0, and so |(I + E)^-1| of all E with |E| <= A. False where the row
/// sums of that are not proven to be at most `most`, a few; a NaN in A is not proven.
inline bool BoundSolution(const double (&a)[3][3], double most, double (&solution)[3][3])
{
  const auto minor = [&a](std::size_t i, std::size_t j)
  {
    const auto at = [&a](std::size_t k, std::size_t l)
    { return (k % 3 == l % 3 ? 1.0 : 0.0) - a[k % 3][l % 3]; };
    return at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1);
  };
  double det = 0.0;
  for (std::size_t j = 0; j < 3; ++j)
  {
    det += ((j == 0 ? 1.0 : 0.0) - a[0][j]) * minor(0, j);
  }
  double sums[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    sums[i] = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      solution[i][j] = minor(j, i) / det;
      sums[i] += solution[i][j];
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    // A x < x with a positive x: the eigenvalues of A are below 1, and the inverse is not negative.
    // Rounding leaves the most of (I - A) x = 1.
    const double image = a[i][0] * sums[0] + a[i][1] * sums[1] + a[i][2] * sums[2];
    if (!(sums[i] > 0.0 && sums[i] <= most && sums[i] - image > 0.5))
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      // (I - A) x > 1/2, so that this is more than what rounding takes off.
      solution[i][j] = std::max(solution[i][j], 0.0) + 1e-11 * sums[i];
    }
  }
  return true;
}

/// The same where the row sums are those of D (I - A)^-1 D^-1, with the diagonal of D, `sides`: of
/// unknowns that are as long as those are in space, so that it does not matter how thin an element
/// is.
inline bool BoundSolution(
  const double (&a)[3][3], const double (&sides)[3], double most, double (&solution)[3][3])
{
  double scaled[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      scaled[i][j] = a[i][j] * (sides[i] / sides[j]) * kUp;
    }
  }
  if (!BoundSolution(scaled, most, solution))
  {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      solution[i][j] *= (sides[j] / sides[i]) * kUp;
    }
  }
  return true;
}

/// Bounds of the solution of (I + E) v = w from those of w, by BoundSolution.
inline void Solve(const double (&solution)[3][3], double (&v)[3])
{
  const double w[3] = { v[0], v[1], v[2] };
  for (std::size_t k = 0; k < 3; ++k)
  {
    v[k] = (solution[k][0] * w[0] + solution[k][1] * w[1] + solution[k][2] * w[2]) * kUp;
  }
}

/// The same from row sums of |E|, below 1.
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
