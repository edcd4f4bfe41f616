// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Rounding.h"
#include "Core/Math/Vec.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

// Arithmetic of bounds along edges: sums and products that are not negative.
namespace pixelexact::edges
{
/// Covers the rounding of about a dozen such operations.
inline constexpr double kUp = 1.0 + 1e-13;
/// The same, as a fraction of the largest operand.
inline constexpr double kRoundoffs = 32.0 * kUnitRoundoff;
/// The distance, in xi, by which a path may leave the element: far less than is visible, and more
/// than rounding makes of an edge in a face.
inline constexpr double kBeside = 1e-13;
/// Rows and columns of a symmetric matrix's entries 11, 12, 13, 22, 23, 33.
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

/// Bounds (I - A)^-1 for A >= 0, and therefore |(I + E)^-1| for all E with |E| <= A. Returns false
/// where its row sums are not proven to be at most `most`, a small number; a NaN in A is never
/// proven.
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
    // Rounding leaves most of (I - A) x = 1.
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
      // (I - A) x > 1/2, so that this exceeds the effect of rounding.
      solution[i][j] = std::max(solution[i][j], 0.0) + 1e-11 * sums[i];
    }
  }
  return true;
}

/// The same for the row sums of D (I - A)^-1 D^-1, where D has the diagonal `sides`. Unknowns are
/// then lengths in space, so that the result does not depend on how thin an element is.
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

/// The same from row sums of |E|, each below 1.
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
