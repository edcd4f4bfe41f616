// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/PolynomialBatch.h"

#include "Core/Bernstein/BatchKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// What is lost below the smallest numbers, by far.
constexpr double kUnderflow = 0x1p-1000;

/// Row k: the factors with which coefficients make the k-th one over a part of [0, 1]. None is
/// negative: they are made with relative errors of gamma(6 n), and sum to 1.
std::vector<double> RestrictionRows(int n, double from, double to)
{
  const auto count = static_cast<std::size_t>(n) + 1;
  std::vector<double> rows(count * count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
  {
    rows[k * count + k] = 1.0;
  }
  // Of the unit vectors, side by side.
  Restrict({ n, n, 0 }, 0, from, to, rows);
  return rows;
}
} // namespace

PolynomialBatch::PolynomialBatch(const Degrees& degree, std::span<const BoxPolynomial> polynomials)
  : Degree(degree)
  , B(CoefficientCount(degree) * polynomials.size())
{
  std::vector<double> raised(CoefficientCount(degree));
  for (std::size_t c = 0; c < polynomials.size(); ++c)
  {
    const BoxPolynomial& one = polynomials[c];
    const double largest = LargestMagnitude(one.b);
    double error = one.error;
    if (one.degree == degree)
    {
      std::ranges::copy(one.b, raised.begin());
    }
    else
    {
      Elevate(one.degree, degree, one.b, raised);
      error = (error + ElevationError(degree, largest) + kUnderflow) * (1.0 + Gamma(4));
    }
    for (std::size_t i = 0; i < raised.size(); ++i)
    {
      B[i * polynomials.size() + c] = raised[i];
    }
    Errors.push_back(error);
    // Sums of parts that add up to one exceed it by roundings alone.
    Largest.push_back(1.0625 * largest + kUnderflow);
  }
}

void PolynomialBatch::HullsOver(const Box3& within, std::span<Interval> hulls) const
{
  std::vector<double> rounds[2];
  const std::vector<double>* now = &B;
  std::vector<double> errors = Errors;
  for (int d = 0; d < 3; ++d)
  {
    const int n = Degree[static_cast<std::size_t>(d)];
    if (n == 0 || (within.lower[d] <= -1.0 && within.upper[d] >= 1.0))
    {
      continue;
    }
    std::vector<double>& next = now == rounds ? rounds[1] : rounds[0];
    next.resize(B.size());
    CombineRows(RestrictionRows(n, 0.5 + within.lower[d] / 2.0, 0.5 + within.upper[d] / 2.0),
      static_cast<std::size_t>(n) + 1, StrideOf(Degree, d) * Count(), *now, next);
    now = &next;
    // The rows, as BoxPolynomial::Restrict, and the sums.
    for (std::size_t c = 0; c < Count(); ++c)
    {
      errors[c] =
        (errors[c] + RestrictionError(n, Largest[c]) + Gamma(9 * n + 8) * Largest[c] + kUnderflow) *
        (1.0 + Gamma(8));
    }
  }
  std::vector<double> ends[2] = { std::vector<double>(Count()), std::vector<double>(Count()) };
  ExtremesOfEach(*now, ends[0], ends[1]);
  for (std::size_t c = 0; c < Count(); ++c)
  {
    hulls[c] = rounding::Outward(ends[0][c] - errors[c], ends[1][c] + errors[c]);
  }
}
} // namespace pixelexact
