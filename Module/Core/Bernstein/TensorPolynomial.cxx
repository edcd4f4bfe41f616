// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/TensorPolynomial.h"

#include "Core/Bernstein/JetBasis.h"
#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pixelexact
{
namespace
{

using Line = std::array<double, kMaxDegree + 1>;

int TotalDegree(const Degrees& degree)
{
  return degree[0] + degree[1] + degree[2];
}

/// The sum of the magnitudes of B_0 .. B_n at t, rounded up.
double Lebesgue(int n, double t)
{
  const double base = std::fabs(t) + std::fabs(1.0 - t);
  return base <= 1.0 ? 1.0 : std::pow(base * (1.0 + Gamma(2)), n) * (1.0 + Gamma(2 * n + 8));
}

double BinomialOfAny(int n, int k)
{
  double result = 1.0;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}
} // namespace

double LargestMagnitude(std::span<const double> coefficients)
{
  if (coefficients.empty())
  {
    return 0.0;
  }
  const NumberExtremes extremes = ExtremesOf(coefficients);
  if (extremes.finite)
  {
    return std::max(-extremes.least, extremes.most);
  }
  return std::ranges::any_of(coefficients, [](double b) { return std::isnan(b); })
    ? std::numeric_limits<double>::quiet_NaN()
    : kInfinity;
}

void Restrict(
  const Degrees& degree, int direction, double from, double to, std::span<double> coefficients)
{
  SweepTo(degree, direction, from,
    from < 1.0 ? std::clamp((to - from) / (1.0 - from), 0.0, 1.0) : 1.0, coefficients);
}

double RestrictionError(int degree, double magnitude)
{
  // Four roundings a level in either sweep. `from` and `to` are off by u, which moves coefficients
  // by at most 2 n u times their magnitude; `rest` by 4 u / (1 - from), against differences that
  // the first sweep has shrunk by 1 - from.
  return Gamma(24 * degree) * magnitude + 16.0 * degree * std::numeric_limits<double>::denorm_min();
}

void Elevate(const Degrees& from, const Degrees& to, std::span<const double> coefficients,
  std::span<double> elevated)
{
  std::vector<double> current(coefficients.begin(), coefficients.end());
  std::vector<double> weights;
  Degrees degree = from;
  for (int d = 0; d < 3; ++d)
  {
    const int n = from[static_cast<std::size_t>(d)];
    const int m = to[static_cast<std::size_t>(d)];
    if (m == n)
    {
      continue;
    }
    Degrees next = degree;
    next[static_cast<std::size_t>(d)] = m;
    std::vector<double> raised(CoefficientCount(next), 0.0);
    const std::size_t stride = StrideOf(degree, d);
    const std::size_t lines = current.size() / (stride * static_cast<std::size_t>(n + 1));
    for (int j = 0; j <= m; ++j)
    {
      const int first = std::max(0, j - (m - n));
      const int last = std::min(n, j);
      weights.clear();
      for (int i = first; i <= last; ++i)
      {
        weights.push_back(BinomialOfAny(j, i) * BinomialOfAny(m - j, n - i) / BinomialOfAny(m, n));
      }
      for (std::size_t line = 0; line < lines; ++line)
      {
        const double* row =
          &current[(line * static_cast<std::size_t>(n + 1) + static_cast<std::size_t>(first)) *
            stride];
        double* sums =
          &raised[(line * static_cast<std::size_t>(m + 1) + static_cast<std::size_t>(j)) * stride];
        for (const double weight : weights)
        {
          for (std::size_t inner = 0; inner < stride; ++inner)
          {
            sums[inner] += weight * row[inner];
          }
          row += stride;
        }
      }
    }
    current = std::move(raised);
    degree = next;
  }
  std::ranges::copy(current, elevated.begin());
}

double ElevationError(const Degrees& to, double magnitude)
{
  // Three binomials of up to 2 m roundings each, their product, and a sum of at most m + 1 terms,
  // in each direction; the weights of a sum add up to one.
  return Gamma(8 * (TotalDegree(to) + 6)) * magnitude +
    (TotalDegree(to) + 3) * std::numeric_limits<double>::denorm_min();
}

Jet EvaluateJet(const Degrees& degree, std::span<const double> coefficients, const Parameters& t)
{
  return JetBasis(degree, t, JetBasis::Parts::Jets).JetOf(coefficients);
}

Interval EncloseValue(
  const Degrees& degree, std::span<const double> coefficients, double error, const Parameters& t)
{
  const double value = JetBasis(degree, t, JetBasis::Parts::Values).ValueOf(coefficients);
  double lebesgue = 1.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    lebesgue *= Lebesgue(degree[d], t[d]);
  }
  // Per direction: 3 roundings a level of the basis, one product and n + 1 sums.
  const double rounding = Gamma(5 * TotalDegree(degree) + 16) * LargestMagnitude(coefficients) +
    64.0 * (TotalDegree(degree) + 1) * std::numeric_limits<double>::denorm_min();
  const double radius = (error + rounding) * lebesgue * (1.0 + Gamma(16));
  return radius <= kInfinity ? Interval::Around(value, radius) : Interval::Everything();
}

Interval EncloseDerivative(const Degrees& degree, int direction,
  std::span<const double> coefficients, double error, double reach)
{
  const int n = degree[static_cast<std::size_t>(direction)];
  if (n == 0)
  {
    return 0.0;
  }
  const std::size_t stride = StrideOf(degree, direction);
  const NumberExtremes differences =
    DifferencesOf(coefficients, stride, stride * static_cast<std::size_t>(n + 1));
  if (!differences.finite)
  {
    return Interval::Everything();
  }
  const Interval difference =
    rounding::Outward(differences.least, differences.most) + Interval(-2.0 * error, 2.0 * error);
  const double middle = difference.Middle();
  const double growth =
    std::pow(1.0 + 2.0 * reach, TotalDegree(degree) - 1) * (1.0 + Gamma(4 * 3 * kMaxDegree));
  const double radius = rounding::Above(difference.RadiusAround(middle) * growth);
  return Interval(n) * Interval::Around(middle, radius);
}

Section ClipToZero(
  const Degrees& degree, int direction, std::span<const double> coefficients, double error)
{
  const auto n = static_cast<std::size_t>(degree[static_cast<std::size_t>(direction)]);
  const std::size_t stride = StrideOf(degree, direction);
  Line low;
  Line high;
  if (!ExtremesAlong(coefficients, stride, stride * (n + 1), low, high) || !(error < kInfinity))
  {
    return {};
  }
  for (std::size_t i = 0; i <= n; ++i)
  {
    low[i] = rounding::Below(low[i] - error);
    high[i] = rounding::Above(high[i] + error);
  }
  const double least = *std::min_element(low.begin(), low.begin() + static_cast<long>(n) + 1);
  const double most = *std::max_element(high.begin(), high.begin() + static_cast<long>(n) + 1);
  if (least > 0.0 || most < 0.0)
  {
    return { 1.0, 0.0 };
  }
  if (n == 0)
  {
    return {};
  }
  // The lower hull is not positive between the outermost chords that cross zero; the same with
  // signs changed for the upper one. Crossings are off by a few roundings: far less than the slack.
  constexpr double kSlack = 1e-9;
  Section section;
  const auto narrow = [&](const Line& edge, double sign)
  {
    double from = kInfinity;
    double to = -kInfinity;
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double b = sign * edge[i];
      const auto at = static_cast<double>(i) / static_cast<double>(n);
      if (b <= 0.0)
      {
        from = std::min(from, at);
        to = std::max(to, at);
        continue;
      }
      for (std::size_t j = 0; j <= n; ++j)
      {
        const double other = sign * edge[j];
        if (other <= 0.0)
        {
          const double step = (static_cast<double>(j) - static_cast<double>(i)) /
            static_cast<double>(n) * (b / (b - other));
          from = std::min(from, at + step);
          to = std::max(to, at + step);
        }
      }
    }
    section.from = std::max(section.from, from - kSlack);
    section.to = std::min(section.to, to + kSlack);
  };
  narrow(low, 1.0);
  narrow(high, -1.0);
  return section;
}
} // namespace pixelexact
