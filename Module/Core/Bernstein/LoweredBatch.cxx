// SPDX-License-Identifier: BSD-3-Clause
// A batch of polynomials in lower degrees.
#include "Core/Bernstein/BatchKernels.h"
#include "Core/Bernstein/PolynomialBatch.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>

namespace pixelexact
{
namespace
{
/// The Bernstein polynomials of a degree at t in [0, 1].
std::vector<double> BasisAt(int n, double t)
{
  std::vector<double> values{ 1.0 };
  for (int k = 1; k <= n; ++k)
  {
    values.push_back(0.0);
    for (std::size_t i = values.size() - 1; i > 0; --i)
    {
      values[i] = (1.0 - t) * values[i] + t * values[i - 1];
    }
    values[0] *= 1.0 - t;
  }
  return values;
}

/// Row k: the factors by which n + 1 coefficients give the k-th of m + 1 < n + 1 coefficients of
/// the polynomial with the same values at Chebyshev's points. The factors are not certified.
std::vector<double> LoweringRows(int n, int m)
{
  const auto rows = static_cast<std::size_t>(m) + 1;
  const auto columns = static_cast<std::size_t>(n) + 1;
  std::vector<std::vector<double>> system;
  for (int i = 0; i <= m; ++i)
  {
    const double t = 0.5 - 0.5 * std::cos((2.0 * i + 1.0) / (2.0 * m + 2.0) * std::numbers::pi);
    std::vector<double> row = BasisAt(m, t);
    std::ranges::copy(BasisAt(n, t), std::back_inserter(row));
    system.push_back(std::move(row));
  }
  for (std::size_t k = 0; k < rows; ++k)
  {
    const auto largest =
      std::max_element(system.begin() + static_cast<std::ptrdiff_t>(k), system.end(),
        [k](const auto& a, const auto& b) { return std::fabs(a[k]) < std::fabs(b[k]); });
    std::iter_swap(system.begin() + static_cast<std::ptrdiff_t>(k), largest);
    for (std::size_t i = 0; i < rows; ++i)
    {
      const double by = i == k ? 0.0 : system[i][k] / system[k][k];
      for (std::size_t j = k; j < rows + columns && by != 0.0; ++j)
      {
        system[i][j] -= by * system[k][j];
      }
    }
  }
  std::vector<double> factors;
  for (std::size_t k = 0; k < rows; ++k)
  {
    for (std::size_t j = 0; j < columns; ++j)
    {
      factors.push_back(system[k][rows + j] / system[k][k]);
    }
  }
  return factors;
}

/// Row i: the factors by which m + 1 coefficients give the i-th of n + 1. None is negative, they
/// sum to 1, and have relative errors of gamma(3 n).
std::vector<double> ElevationRows(int m, int n)
{
  const auto columns = static_cast<std::size_t>(m) + 1;
  std::vector<double> factors((static_cast<std::size_t>(n) + 1) * columns, 0.0);
  for (std::size_t j = 0; j < columns; ++j)
  {
    // Elevates the unit vectors one degree at a time.
    std::vector<double> b(columns, 0.0);
    b[j] = 1.0;
    for (int degree = m + 1; degree <= n; ++degree)
    {
      b.push_back(0.0);
      for (int i = degree; i >= 0; --i)
      {
        const double before = i > 0 ? b[static_cast<std::size_t>(i) - 1] * (i * 1.0 / degree) : 0.0;
        const auto at = static_cast<std::size_t>(i);
        b[at] = before + b[at] * ((degree - i) * 1.0 / degree);
      }
    }
    for (std::size_t i = 0; i < b.size(); ++i)
    {
      factors[i * columns + j] = b[i];
    }
  }
  return factors;
}
} // namespace

PolynomialBatch PolynomialBatch::Lowered(double part) const
{
  PolynomialBatch lowered = *this;
  const double most = Largest.empty() ? 0.0 : std::ranges::max(Largest);
  for (int d = 0; d < 3; ++d)
  {
    lowered.LowerAlong(d, part * most / 3.0);
  }
  return lowered;
}

void PolynomialBatch::LowerAlong(int direction, double most)
{
  const auto d = static_cast<std::size_t>(direction);
  const int n = degree_[d];
  const std::size_t columns = static_cast<std::size_t>(n) + 1;
  const std::size_t stride = StrideOf(degree_, direction) * Count();
  std::vector<double> again(B.size());
  std::vector<double> ends[2] = { std::vector<double>(Count()), std::vector<double>(Count()) };
  // The lowest degree that is known to suffice, and the highest that is known not to suffice.
  int enough = n;
  int tooLow = 0;
  std::vector<double> kept;
  std::vector<double> keptErrors;
  while (enough - tooLow > 1)
  {
    const int m = (enough + tooLow) / 2;
    const std::size_t rows = static_cast<std::size_t>(m) + 1;
    std::vector<double> lower(B.size() / columns * rows);
    CombineRows(LoweringRows(n, m), rows, columns, stride, B, lower);
    CombineRows(ElevationRows(m, n), columns, rows, stride, lower, again);
    std::ranges::transform(B, again, again.begin(), std::minus<>());
    std::vector<double> errors(Count());
    std::vector<double> lowerEnds[2] = { std::vector<double>(Count()),
      std::vector<double>(Count()) };
    ExtremesOfEach(lower, lowerEnds[0], lowerEnds[1]);
    ExtremesOfEach(again, ends[0], ends[1]);
    double off = 0.0;
    for (std::size_t c = 0; c < Count(); ++c)
    {
      // The hull of the polynomial minus the lowered one, in the higher degree, with its rounding.
      const double apart = std::max(std::fabs(ends[0][c]), std::fabs(ends[1][c]));
      const double terms = std::max(std::fabs(lowerEnds[0][c]), std::fabs(lowerEnds[1][c]));
      errors[c] =
        (apart + Gamma(4 * n + 16) * (terms + Largest[c]) + kUnderflow) * (1.0 + Gamma(4));
      off = std::max(off, errors[c]);
    }
    // The comparison is written so that it rejects NaN.
    if (off <= most)
    {
      enough = m;
      kept = std::move(lower);
      keptErrors = std::move(errors);
    }
    else
    {
      tooLow = m;
    }
  }
  if (enough == n)
  {
    return;
  }
  degree_[d] = enough;
  B = std::move(kept);
  ExtremesOfEach(B, ends[0], ends[1]);
  for (std::size_t c = 0; c < Count(); ++c)
  {
    Errors[c] = (Errors[c] + keptErrors[c]) * (1.0 + Gamma(4));
    Largest[c] = 1.0625 * std::max(std::fabs(ends[0][c]), std::fabs(ends[1][c])) + kUnderflow;
  }
}
} // namespace pixelexact
