// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/ChebyshevModel.h"

#include "Core/Math/Rounding.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr int kDegree = ChebyshevModel::kDegree;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Covers the roundings of sums and products of bounds, of which there are less than 4000, and
/// underflow.
double Up(double bound)
{
  return bound * (1.0 + 0x1p-40) + 0x1p-1000;
}
/// Additions to one coefficient of a product, and what else rounds.
constexpr int kProductRoundings = 4 * (kDegree + 1) * (kDegree + 1) + 8;
/// Steps of Newton's iteration, which doubles the digits.
constexpr int kNewtonSteps = 7;

/// Chebyshev's polynomials in Bernstein's form of degree kDegree over [-1, 1]: T_n has
/// (-1)^(n-i) C(2n, 2i) / C(n, i) in its own degree, which is then raised.
struct ToBernstein
{
  ToBernstein()
  {
    for (int n = 0; n <= kDegree; ++n)
    {
      auto& b = column[static_cast<std::size_t>(n)];
      double even = 1.0; // C(2n, 2i)
      double all = 1.0;  // C(n, i)
      for (int i = 0; i <= n; ++i)
      {
        b[static_cast<std::size_t>(i)] = ((n - i) % 2 == 0 ? 1.0 : -1.0) * even / all;
        even = even * (2 * n - 2 * i) / (2 * i + 1) * (2 * n - 2 * i - 1) / (2 * i + 2);
        all = all * (n - i) / (i + 1);
      }
      for (int m = n; m < kDegree; ++m)
      {
        b[static_cast<std::size_t>(m) + 1] = b[static_cast<std::size_t>(m)];
        for (int i = m; i > 0; --i)
        {
          const double part = static_cast<double>(i) / (m + 1);
          b[static_cast<std::size_t>(i)] = part * b[static_cast<std::size_t>(i) - 1] +
            (1.0 - part) * b[static_cast<std::size_t>(i)];
        }
      }
      for (const double value : b)
      {
        largest = std::max(largest, std::fabs(value));
      }
    }
  }
  std::array<std::array<double, kDegree + 1>, kDegree + 1> column{}; ///< [n][i]
  double largest = 1.0;
};
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
  static const ToBernstein kChange;
  constexpr std::size_t n = kDegree;
  double half[n + 1][n + 1] = {}; // Chebyshev's in s, Bernstein's in t
  for (std::size_t i = 0; i <= n; ++i)
  {
    for (std::size_t j = 0; i + j <= n; ++j)
    {
      const double value = c[Index(static_cast<int>(i), static_cast<int>(j))];
      for (std::size_t l = 0; l <= n && value != 0.0; ++l)
      {
        half[i][l] += value * kChange.column[j][l];
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
        value += kChange.column[i][k] * half[i][l];
      }
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  const double radius =
    Up(error + Gamma(4 * kDegree + 8) * kChange.largest * kChange.largest * Norm());
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

ChebyshevModel operator*(double a, const ChebyshevModel& b)
{
  ChebyshevModel product;
  double size = 0.0;
  for (std::size_t i = 0; i < ChebyshevModel::kSize; ++i)
  {
    product.c[i] = a * b.c[i];
    size += std::fabs(product.c[i]);
  }
  product.error = Up(std::fabs(a) * b.error + kUnitRoundoff * size);
  return product;
}

ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b)
{
  // T_i T_k = (T_{i+k} + T_{|i-k|}) / 2, in both variables; all of the product first. Of one pair
  // of i and k, row[n + m] is the factor of T_m; what is before the middle is folded at last.
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

ChebyshevModel Reciprocal(const ChebyshevModel& f)
{
  ChebyshevModel unknown;
  unknown.error = kInfinity;
  if (f.Range().Contains(0.0))
  {
    return unknown;
  }
  const ChebyshevModel p = f.Polynomial();
  ChebyshevModel r(1.0 / f.c[0]);
  for (int step = 0; step < kNewtonSteps; ++step)
  {
    const ChebyshevModel left = ChebyshevModel(1.0) - p * r;
    r = (r + r * left).Polynomial();
    if (left.Norm() < 1e-9)
    {
      break;
    }
  }
  // 1/f = r / (1 - d) with d = 1 - f r.
  const double d = (ChebyshevModel(1.0) - f * r).Range().Magnitude();
  if (!(d < 1.0))
  {
    return unknown;
  }
  r.error = Up(r.Range().Magnitude() * d / (1.0 - d));
  return r;
}

ChebyshevModel SquareRoot(const ChebyshevModel& f)
{
  ChebyshevModel unknown;
  unknown.error = kInfinity;
  const double least = f.Range().lower;
  if (!(least > 0.0))
  {
    return unknown;
  }
  // Newton's iteration for 1 / sqrt(f), which needs no quotients.
  const ChebyshevModel p = f.Polynomial();
  ChebyshevModel r(1.0 / std::sqrt(f.c[0]));
  for (int step = 0; step < kNewtonSteps; ++step)
  {
    const ChebyshevModel left = ChebyshevModel(1.0) - p * (r * r);
    r = (r + 0.5 * (r * left)).Polynomial();
    if (left.Norm() < 1e-9)
    {
      break;
    }
  }
  ChebyshevModel s = (p * r).Polynomial();
  // sqrt(f) - s = (f - s^2) / (sqrt(f) + s).
  if (!(s.Range().lower > 0.0))
  {
    return unknown;
  }
  s.error = Up((f - s * s).Range().Magnitude() / std::sqrt(least) * (1.0 + 0x1p-40));
  return s;
}

void AddRoughness(const ChebyshevModel& model, std::array<double, 2>& along)
{
  /// Lower terms decide where there are no higher ones.
  constexpr double kLower = 1e-9;
  constexpr int kHighest = 3;
  const double scale = 1.0 / (model.Norm() + 0x1p-1000);
  for (int i = 0; i <= kDegree; ++i)
  {
    for (int j = 0; i + j <= kDegree; ++j)
    {
      const double size = scale * std::fabs(model.c[ChebyshevModel::Index(i, j)]) *
        (i + j > kDegree - kHighest ? 1.0 : kLower);
      along[0] += size * i;
      along[1] += size * j;
    }
  }
}
} // namespace pixelexact
