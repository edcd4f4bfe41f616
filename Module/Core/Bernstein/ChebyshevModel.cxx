// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/ChebyshevModel.h"

#include "Core/Bernstein/ChebyshevBasis.h"
#include "Core/Math/Rounding.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr int kDegree = ChebyshevModel::kDegree;
/// Additions to one coefficient of a product, and what else rounds.
constexpr int kProductRoundings = 4 * (kDegree + 1) * (kDegree + 1) + 8;
} // namespace

ChebyshevModel::ChebyshevModel(const Interval& value)
{
  const double middle = value.IsFinite() ? value.Middle() : 0.0;
  c[0] = middle;
  error = value.IsFinite() ? value.RadiusAround(middle) : kInfinity;
}

ChebyshevModel ChebyshevModel::First()
{
  ChebyshevModel s;
  s.c[Index(1, 0)] = 1.0;
  return s;
}

ChebyshevModel ChebyshevModel::Second()
{
  ChebyshevModel t;
  t.c[Index(0, 1)] = 1.0;
  return t;
}

double ChebyshevModel::Norm(bool withFirst) const
{
  double sum = 0.0;
  for (std::size_t i = withFirst ? 0 : 1; i < kSize; ++i)
  {
    sum += std::fabs(c[i]);
  }
  return Up(sum);
}

Interval ChebyshevModel::Range() const
{
  const double radius = Up(Norm(false) + error);
  return std::isfinite(radius) ? Interval::Around(c[0], radius) : Interval::Everything();
}

Interval ChebyshevModel::TightRange() const
{
  const Interval wide = Range();
  if (!wide.IsFinite())
  {
    return wide;
  }
  const ChebyshevInBernstein& change = ChebyshevInBernstein::Get();
  constexpr std::size_t n = kDegree;
  double half[n + 1][n + 1] = {}; // Chebyshev's in s, Bernstein's in t
  for (std::size_t i = 0; i <= n; ++i)
  {
    for (std::size_t j = 0; i + j <= n; ++j)
    {
      const double value = c[Index(static_cast<int>(i), static_cast<int>(j))];
      for (std::size_t l = 0; l <= n && value != 0.0; ++l)
      {
        half[i][l] += value * change.column[j][l];
      }
    }
  }
  double least = kInfinity;
  double most = -kInfinity;
  for (std::size_t k = 0; k <= n; ++k)
  {
    for (std::size_t l = 0; l <= n; ++l)
    {
      double value = 0.0;
      for (std::size_t i = 0; i <= n; ++i)
      {
        value += change.column[i][k] * half[i][l];
      }
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  const double radius =
    Up(error + Gamma(4 * kDegree + 8) * change.largest * change.largest * Norm());
  return Intersect(wide, rounding::Outward(least - radius, most + radius));
}

Interval ChebyshevModel::Integral() const
{
  if (!std::isfinite(error))
  {
    return Interval::Everything();
  }
  Interval sum = Interval(4.0) * Interval(-error, error);
  for (int i = 0; i <= kDegree; i += 2)
  {
    for (int j = 0; i + j <= kDegree; j += 2)
    {
      const Interval weight =
        Interval(2.0) / Interval(1.0 - i * i) * Interval(2.0) / Interval(1.0 - j * j);
      sum += weight * Interval(c[Index(i, j)]);
    }
  }
  return sum;
}

ChebyshevModel ChebyshevModel::Polynomial() const
{
  ChebyshevModel p = *this;
  p.error = 0.0;
  return p;
}

ChebyshevModel ChebyshevModel::Transposed() const
{
  ChebyshevModel other;
  for (int i = 0; i <= kDegree; ++i)
  {
    for (int j = 0; i + j <= kDegree; ++j)
    {
      other.c[Index(j, i)] = c[Index(i, j)];
    }
  }
  other.error = error;
  return other;
}

ChebyshevModel ChebyshevModel::ByT() const
{
  // c'_{j-1} = c'_{j+1} + 2 j c_j, and half of it at the start.
  ChebyshevModel slope;
  double size = 0.0;
  for (int i = 0; i <= kDegree; ++i)
  {
    for (int j = kDegree - i; j > 0; --j)
    {
      const double above = i + j + 1 <= kDegree ? slope.c[Index(i, j + 1)] : 0.0;
      slope.c[Index(i, j - 1)] = above + 2.0 * j * c[Index(i, j)];
      size += std::fabs(slope.c[Index(i, j - 1)]);
    }
    slope.c[Index(i, 0)] *= 0.5;
  }
  slope.error = error > 0.0 ? kInfinity : Up(Gamma(2 * kDegree) * kDegree * size);
  return slope;
}

void ChebyshevModel::Widen(double radius)
{
  error = Up(error + radius);
}

ChebyshevModel operator+(const ChebyshevModel& a, const ChebyshevModel& b)
{
  ChebyshevModel sum;
  double size = 0.0;
  for (std::size_t i = 0; i < ChebyshevModel::kSize; ++i)
  {
    sum.c[i] = a.c[i] + b.c[i];
    size += std::fabs(sum.c[i]);
  }
  sum.error = Up(a.error + b.error + kUnitRoundoff * size);
  return sum;
}

ChebyshevModel operator-(const ChebyshevModel& a, const ChebyshevModel& b)
{
  return a + -1.0 * b;
}

ChebyshevModel ChebyshevModel::Times(double factor) const
{
  ChebyshevModel product;
  double size = 0.0;
  for (std::size_t i = 0; i < kSize; ++i)
  {
    product.c[i] = factor * c[i];
    size += std::fabs(product.c[i]);
  }
  product.error = Up(std::fabs(factor) * error + kUnitRoundoff * size);
  return product;
}

ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b)
{
  // T_i T_k = (T_{i+k} + T_{|i-k|}) / 2, in both variables. The whole product comes first: for one
  // pair of i and k, row[n + m] is the factor of T_m; negative m are folded at the end.
  constexpr std::size_t n = kDegree;
  double all[2 * n + 1][2 * n + 1] = {};
  for (std::size_t i = 0; i <= n; ++i)
  {
    const double* const left = &a.c[ChebyshevModel::Index(static_cast<int>(i), 0)];
    if (std::all_of(left, left + (n - i) + 1, [](double v) { return v == 0.0; }))
    {
      continue;
    }
    for (std::size_t k = 0; k <= n; ++k)
    {
      const double* const right = &b.c[ChebyshevModel::Index(static_cast<int>(k), 0)];
      double row[3 * n + 1] = {};
      const std::size_t count = n - k + 1;
      for (std::size_t j = 0; i + j <= n; ++j)
      {
        const double factor = 0.25 * left[j];
        if (factor == 0.0)
        {
          continue;
        }
        double* const above = row + n + j;
        double* const below = row + n - j;
        for (std::size_t l = 0; l < count; ++l)
        {
          above[l] += factor * right[l];
        }
        for (std::size_t l = 0; l < count; ++l)
        {
          below[l] += factor * right[l];
        }
      }
      const std::size_t last = n - i + n - k;
      double* const sum = all[i + k];
      double* const difference = all[i > k ? i - k : k - i];
      sum[0] += row[n];
      difference[0] += row[n];
      for (std::size_t m = 1; m <= last; ++m)
      {
        const double value = m <= n ? row[n + m] + row[n - m] : row[n + m];
        sum[m] += value;
        difference[m] += value;
      }
    }
  }
  ChebyshevModel product;
  double dropped = 0.0;
  for (std::size_t i = 0; i <= 2 * n; ++i)
  {
    for (std::size_t j = 0; j <= 2 * n; ++j)
    {
      if (i + j <= n)
      {
        product.c[ChebyshevModel::Index(static_cast<int>(i), static_cast<int>(j))] = all[i][j];
      }
      else
      {
        dropped += std::fabs(all[i][j]);
      }
    }
  }
  const double a1 = a.Norm();
  const double b1 = b.Norm();
  // An unknown factor makes the product unknown, also times zero.
  product.error = std::isfinite(a.error) && std::isfinite(b.error)
    ? Up(a1 * b.error + b1 * a.error + a.error * b.error + dropped +
        Gamma(kProductRoundings) * a1 * b1)
    : kInfinity;
  return product;
}
} // namespace pixelexact
