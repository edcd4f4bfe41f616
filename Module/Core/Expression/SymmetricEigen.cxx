// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/SymmetricEigen.h"

#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
SymmetricEigen::SymmetricEigen(const std::array<double, 6>& matrix)
{
  const auto [xx, yy, zz, xy, yz, xz] = matrix;
  Mat3 a{ xx, xy, xz, xy, yy, yz, xz, yz, zz };
  if (!std::isfinite(xx + yy + zz + xy + yz + xz))
  {
    Values = Vec3(std::numeric_limits<double>::quiet_NaN());
    Vectors = Mat3(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  // They converge quadratically: 5 or 6 rounds leave nothing.
  constexpr int kMaxRounds = 30;
  for (int round = 0; round < kMaxRounds; ++round)
  {
    bool isDiagonal = true;
    for (const auto& [p, q] : { std::pair(0, 1), std::pair(0, 2), std::pair(1, 2) })
    {
      const double off = a[p][q];
      if (std::fabs(off) <= 0x1p-60 * std::sqrt(std::fabs(a[p][p])) * std::sqrt(std::fabs(a[q][q])))
      {
        continue;
      }
      isDiagonal = false;
      const double theta = (a[q][q] - a[p][p]) / (2.0 * off);
      const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::fabs(theta) + std::hypot(theta, 1.0));
      const double c = 1.0 / std::sqrt(t * t + 1.0);
      const double s = t * c;
      const int r = 3 - p - q;
      a[p][p] -= t * off;
      a[q][q] += t * off;
      a[p][q] = a[q][p] = 0.0;
      const double ofP = a[p][r];
      const double ofQ = a[q][r];
      a[p][r] = a[r][p] = c * ofP - s * ofQ;
      a[q][r] = a[r][q] = s * ofP + c * ofQ;
      const Vec3 vp = Vectors[p];
      Vectors[p] = c * vp - s * Vectors[q];
      Vectors[q] = s * vp + c * Vectors[q];
    }
    if (isDiagonal)
    {
      break;
    }
  }
  Values = { a[0][0], a[1][1], a[2][2] };
  for (const auto& [i, j] : { std::pair(0, 1), std::pair(1, 2), std::pair(0, 1) })
  {
    if (Values[i] < Values[j])
    {
      std::swap(Values[i], Values[j]);
      std::swap(Vectors[i], Vectors[j]);
    }
  }
}
} // namespace pixelexact
