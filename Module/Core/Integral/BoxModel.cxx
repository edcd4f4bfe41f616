// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/BoxModel.h"

#include "Core/Base/MadeOnDemand.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace pixelexact
{
namespace
{
/// The change from Bernstein coefficients over [-1, 1] to Chebyshev coefficients over [-reach,
/// reach]: the discrete cosine transform of values at Chebyshev's points, exact up to rounding.
struct Change
{
  Change(int degree, double reach);

  std::size_t count;
  std::vector<double> matrix; ///< [k * count + i]
  std::vector<double> sum;    ///< of a column's magnitudes
  double growth;              ///< of errors of the Bernstein coefficients
};

Change::Change(int degree, double reach)
  : count(static_cast<std::size_t>(degree) + 1)
  , matrix(count * count)
  , sum(count)
  , growth(Up(std::pow(reach, degree)))
{
  std::vector<long double> bernstein(count * count); // [m * count + i]
  const auto angle = [&](std::size_t m)
  {
    return (2 * static_cast<long double>(m) + 1) * std::numbers::pi_v<long double> /
      (2 * static_cast<long double>(count));
  };
  for (std::size_t m = 0; m < count; ++m)
  {
    const long double s = reach * std::cos(angle(m));
    long double* const row = &bernstein[m * count];
    row[0] = 1.0L;
    for (std::size_t n = 1; n < count; ++n)
    {
      row[n] = row[n - 1] * (1 + s) / 2;
      for (std::size_t i = n - 1; i > 0; --i)
      {
        row[i] = row[i] * (1 - s) / 2 + row[i - 1] * (1 + s) / 2;
      }
      row[0] *= (1 - s) / 2;
    }
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      long double entry = 0.0L;
      for (std::size_t m = 0; m < count; ++m)
      {
        entry += bernstein[m * count + i] * std::cos(static_cast<long double>(k) * angle(m));
      }
      entry *= (k == 0 ? 1.0L : 2.0L) / static_cast<long double>(count);
      matrix[k * count + i] = static_cast<double>(entry);
      sum[i] += static_cast<double>(std::fabs(entry));
    }
  }
}

const Change& ChangeOf(int degree, bool widened)
{
  static const std::array<MadeOnDemand<Change>, 2> kMade{ MadeOnDemand<Change>(kMaxDegree + 1),
    MadeOnDemand<Change>(kMaxDegree + 1) };
  return kMade[widened ? 1 : 0].Get(static_cast<std::size_t>(degree),
    [&] { return std::make_unique<const Change>(degree, widened ? BoxModel::kReach : 1.0); });
}

/// Replaces the coefficients along a direction.
void Apply(const Change& change, std::size_t stride, std::vector<double>& values)
{
  const std::size_t n = change.count;
  std::vector<double> line(n * stride);
  for (std::size_t start = 0; start < values.size(); start += n * stride)
  {
    std::ranges::fill(line, 0.0);
    for (std::size_t k = 0; k < n; ++k)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        const double factor = change.matrix[k * n + i];
        for (std::size_t at = 0; at < stride; ++at)
        {
          line[k * stride + at] += factor * values[start + i * stride + at];
        }
      }
    }
    std::ranges::copy(line, values.begin() + static_cast<std::ptrdiff_t>(start));
  }
}
} // namespace

BoxModel::BoxModel(const BoxPolynomial& polynomial, const std::array<int, 3>& axes, bool wideB)
{
  const Degrees& degree = polynomial.degree;
  std::array<const Change*, 3> change{}; // by direction of the box
  for (std::size_t v = 0; v < 3; ++v)
  {
    const auto d = static_cast<std::size_t>(axes[v]);
    change[d] = &ChangeOf(degree[d], v == 2 || (v == 1 && wideB));
  }
  // Subtracts a common base from the coefficients first: smaller numbers have smaller rounding
  // errors.
  std::vector<double> values = polynomial.b;
  const double base = values[values.size() / 2];
  double rounded = 0.0;
  double largest = std::fabs(base);
  std::size_t at = 0;
  for (std::size_t i = 0; i < change[0]->count; ++i)
  {
    for (std::size_t j = 0; j < change[1]->count; ++j)
    {
      for (std::size_t k = 0; k < change[2]->count; ++k, ++at)
      {
        values[at] -= base;
        largest = std::max(largest, std::fabs(values[at]));
        rounded +=
          std::fabs(values[at]) * change[0]->sum[i] * change[1]->sum[j] * change[2]->sum[k];
      }
    }
  }
  for (int d = 0; d < 3; ++d)
  {
    Apply(*change[static_cast<std::size_t>(d)], StrideOf(degree, d), values);
  }
  const double growth = change[0]->growth * change[1]->growth * change[2]->growth;
  Error = Up((polynomial.error + 2.0 * kUnitRoundoff * largest) * growth +
    Gamma(3 * (degree[0] + degree[1] + degree[2]) + 24) * rounded);
  at = 0;
  std::array<std::size_t, 3> index{};
  for (index[0] = 0; index[0] < change[0]->count; ++index[0])
  {
    for (index[1] = 0; index[1] < change[1]->count; ++index[1])
    {
      for (index[2] = 0; index[2] < change[2]->count; ++index[2], ++at)
      {
        const std::size_t i = index[static_cast<std::size_t>(axes[0])];
        const std::size_t j = index[static_cast<std::size_t>(axes[1])];
        const std::size_t k = index[static_cast<std::size_t>(axes[2])];
        const double value = std::fabs(values[at]);
        if (i + j + k > static_cast<std::size_t>(kDegree))
        {
          Error += value;
          continue;
        }
        P[k][j][i] = values[at];
        SlopeB += value * static_cast<double>(j * j);
        SlopeC += value * static_cast<double>(k * k);
      }
    }
  }
  P[0][0][0] += base;
  Error = Up(Error + kUnitRoundoff * std::fabs(P[0][0][0]));
  SlopeB = Up(SlopeB);
  SlopeC = Up(SlopeC);
  if (!std::isfinite(largest))
  {
    Error = std::numeric_limits<double>::infinity();
  }
}

Interval BoxModel::Range() const
{
  double rest = 0.0;
  for (const auto& plane : P)
  {
    for (const auto& row : plane)
    {
      for (const double value : row)
      {
        rest += std::fabs(value);
      }
    }
  }
  const double radius = Up(rest - std::fabs(P[0][0][0]) + kUnitRoundoff * 200.0 * rest + Error);
  return std::isfinite(radius) ? Interval::Around(P[0][0][0], radius) : Interval::Everything();
}

PointedModels::PointedModels(const ChebyshevModel& b, const ChebyshevModel& c)
  : Within(b.TightRange().Magnitude() <= BoxModel::kReach &&
      c.TightRange().Magnitude() <= BoxModel::kReach)
  , ErrorB(b.error)
  , ErrorC(c.error)
  , B(PowersOf(b.Polynomial()))
  , C(PowersOf(c.Polynomial()))
{
}

PointedModels::PointedModels(const ChebyshevModel& c)
  : Within(c.TightRange().Magnitude() <= BoxModel::kReach)
  , PlainB(true)
  , ErrorC(c.error)
  , C(PowersOf(c.Polynomial()))
{
}

PointedModels::Powers PointedModels::PowersOf(const ChebyshevModel& argument)
{
  Powers powers;
  powers[0] = ChebyshevModel(1.0);
  powers[1] = (1.0 / BoxModel::kReach) * argument;
  powers[1].Widen(2.0 * kUnitRoundoff * argument.Norm());
  const ChebyshevModel twice = 2.0 * powers[1];
  for (std::size_t n = 2; n < powers.size(); ++n)
  {
    powers[n] = twice * powers[n - 1] - powers[n - 2];
  }
  return powers;
}

ChebyshevModel PointedModels::Of(const BoxModel& f) const
{
  constexpr std::size_t n = ChebyshevModel::kDegree;
  ChebyshevModel sum;
  for (std::size_t k = 0; k <= n; ++k)
  {
    ChebyshevModel inner;
    bool any = false;
    for (std::size_t j = 0; j + k <= n; ++j)
    {
      ChebyshevModel row;
      bool inRow = false;
      for (std::size_t i = 0; i + j + k <= n; ++i)
      {
        const double value = f.P[k][j][i];
        inRow = inRow || value != 0.0;
        (PlainB ? inner : row)
          .c[ChebyshevModel::Index(static_cast<int>(i), PlainB ? static_cast<int>(j) : 0)] = value;
      }
      if (inRow && !PlainB)
      {
        inner = inner + (j == 0 ? row : row * B[j]);
      }
      any = any || inRow;
    }
    if (any)
    {
      sum = sum + (k == 0 ? inner : inner * C[k]);
    }
  }
  sum.Widen(f.Error + f.SlopeB * ErrorB + f.SlopeC * ErrorC);
  return sum;
}
} // namespace pixelexact
