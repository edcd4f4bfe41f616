// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/PolynomialBatch.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Bernstein/BatchKernels.h"
#include "Core/Math/Mat.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
/// Row k: the factors by which the coefficients give the k-th one over a part of [0, 1]. None is
/// negative, they have relative errors of gamma(6 n) and sum to 1.
std::vector<double> RestrictionRows(int n, double from, double to)
{
  const auto count = static_cast<std::size_t>(n) + 1;
  std::vector<double> rows(count * count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
  {
    rows[k * count + k] = 1.0;
  }
  // Restricts the unit vectors side by side.
  Restrict({ n, n, 0 }, 0, from, to, rows);
  return rows;
}
} // namespace

PolynomialBatch::PolynomialBatch(const Degrees& degree, std::span<const BoxPolynomial> polynomials)
  : degree_(degree)
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
    // Sums of nonnegative factors that add up to one exceed it only by rounding.
    Largest.push_back(1.0625 * largest + kUnderflow);
  }
}

void PolynomialBatch::HullsOver(const Box3& within, std::span<Interval> hulls) const
{
  const CheckedOut<Restricted> lease;
  Restricted& part = *lease;
  RestrictTo(within, part);
  FindHulls(part, hulls);
}

void PolynomialBatch::BoundsOver(const Box3& within, std::span<Interval> hulls,
  std::span<const Vec3> places, std::span<AffineBound> bounds) const
{
  const CheckedOut<Restricted> lease;
  Restricted& part = *lease;
  RestrictTo(within, part);
  FindHulls(part, hulls);
  FindBounds(part, places, bounds);
}

void PolynomialBatch::RestrictTo(const Box3& within, Restricted& part) const
{
  auto& [rounds, errors, now] = part;
  now = &B;
  errors = Errors;
  for (int d = 0; d < 3; ++d)
  {
    const int n = degree_[static_cast<std::size_t>(d)];
    if (n == 0 || (within.lower[d] <= -1.0 && within.upper[d] >= 1.0))
    {
      continue;
    }
    std::vector<double>& next = now == rounds ? rounds[1] : rounds[0];
    next.resize(B.size());
    CombineRows(RestrictionRows(n, 0.5 + within.lower[d] / 2.0, 0.5 + within.upper[d] / 2.0),
      static_cast<std::size_t>(n) + 1, static_cast<std::size_t>(n) + 1,
      StrideOf(degree_, d) * Count(), *now, next);
    now = &next;
    // The rows, as BoxPolynomial::Restrict, and the sums.
    for (std::size_t c = 0; c < Count(); ++c)
    {
      errors[c] =
        (errors[c] + RestrictionError(n, Largest[c]) + Gamma(9 * n + 8) * Largest[c] + kUnderflow) *
        (1.0 + Gamma(8));
    }
  }
}

void PolynomialBatch::FindHulls(const Restricted& part, std::span<Interval> hulls) const
{
  std::vector<double> ends[2] = { std::vector<double>(Count()), std::vector<double>(Count()) };
  ExtremesOfEach(*part.b, ends[0], ends[1]);
  for (std::size_t c = 0; c < Count(); ++c)
  {
    hulls[c] = rounding::Outward(ends[0][c] - part.errors[c], ends[1][c] + part.errors[c]);
  }
}

void PolynomialBatch::FindBounds(
  const Restricted& part, std::span<const Vec3> places, std::span<AffineBound> bounds) const
{
  const std::size_t first = Count() - bounds.size();
  // Fits the slope to the corners by least squares: the inverse of sum x x^T times sum x f, x from
  // the mean.
  std::array<std::size_t, 8> corners;
  Vec3 mean(0.0);
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    corners[corner] = 0;
    for (int d = 0; d < 3; ++d)
    {
      const auto last = static_cast<std::size_t>(degree_[static_cast<std::size_t>(d)]);
      corners[corner] += (corner >> d & 1U) != 0 ? last * StrideOf(degree_, d) : 0;
    }
    mean += places[corners[corner]] / 8.0;
  }
  Mat3 squares(0.0);
  for (const std::size_t corner : corners)
  {
    const Vec3 x = places[corner] - mean;
    squares += glm::outerProduct(x, x);
  }
  const Mat3 inverse = glm::inverse(squares);
  Vec3 farthest(0.0);
  for (const Vec3& x : places)
  {
    farthest = glm::max(farthest, glm::abs(x));
  }
  std::array<std::vector<double>, 3> slopes;
  slopes.fill(std::vector<double>(bounds.size(), 0.0));
  for (const std::size_t corner : corners)
  {
    const Vec3 weight = inverse * (places[corner] - mean);
    for (std::size_t c = 0; c < bounds.size(); ++c)
    {
      const double b = (*part.b)[corner * Count() + first + c];
      for (int d = 0; d < 3; ++d)
      {
        slopes[static_cast<std::size_t>(d)][c] += weight[d] * b;
      }
    }
  }
  for (std::size_t c = 0; c < bounds.size(); ++c)
  {
    if (!std::isfinite(slopes[0][c] + slopes[1][c] + slopes[2][c]))
    {
      slopes[0][c] = slopes[1][c] = slopes[2][c] = 0.0;
    }
  }
  std::vector<double> ends[2] = { std::vector<double>(bounds.size()),
    std::vector<double>(bounds.size()) };
  ExtremesBesideAffine(
    std::span(*part.b).subspan(first), Count(), places, slopes, ends[0], ends[1]);
  for (std::size_t c = 0; c < bounds.size(); ++c)
  {
    AffineBound& bound = bounds[c];
    bound.value = 0.5 * (ends[0][c] + ends[1][c]);
    double rounding = Gamma(8) * Largest[first + c];
    for (int d = 0; d < 3; ++d)
    {
      const double slope = slopes[static_cast<std::size_t>(d)][c];
      bound.slope[static_cast<std::size_t>(d)] = slope;
      rounding += std::fabs(slope) * (Gamma(8) * farthest[d] + 64.0 * kUnitRoundoff);
    }
    bound.radius = (std::max(ends[1][c] - bound.value, bound.value - ends[0][c]) +
                     part.errors[first + c] + rounding + kUnderflow) *
      (1.0 + Gamma(16));
  }
}
} // namespace pixelexact
