// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Rational/RationalElement.h"

#include "Core/Basis/Space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pixelexact::rational
{
namespace
{
/// Relative difference of weights along a direction that counts as rounding.
constexpr long double kSameWeights = 64 * kLongRoundoff;

using Grid = std::vector<long double>;

GridSize SizeOf(const Orders& degree)
{
  return { degree[0] + 1, degree[1] + 1, degree[2] + 1 };
}

/// The matrix of each direction.
using Lines = std::array<const LineMatrix*, 3>;

Grid Evaluate(std::span<const long double> coefficients, const Orders& degree, const Lines& lines)
{
  Grid grid(coefficients.begin(), coefficients.end());
  GridSize size = SizeOf(degree);
  for (int d = 0; d < 3; ++d)
  {
    Sweep(grid, size, d, *lines[static_cast<std::size_t>(d)]);
  }
  return grid;
}

std::span<const long double> Numerator(const RationalElement& element, int component)
{
  const std::size_t points = element.weights.size();
  return std::span(element.numerators)
    .subspan(static_cast<std::size_t>(component) * points, points);
}

/// N / w, without the shift, at the points of the lines.
std::vector<Grid> Ratios(const RationalElement& element, const Lines& lines)
{
  const Grid weights = Evaluate(element.weights, element.degree, lines);
  std::vector<Grid> ratios;
  for (int c = 0; c < element.Components(); ++c)
  {
    Grid& ratio = ratios.emplace_back(Evaluate(Numerator(element, c), element.degree, lines));
    std::ranges::transform(ratio, weights, ratio.begin(), std::divides<>());
  }
  return ratios;
}

Lines ToNodes(const RationalElement& element, const Orders& order, LineTables& tables)
{
  Lines lines{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    lines[d] = &tables.BernsteinToNodes(element.degree[d], order[d]);
  }
  return lines;
}

/// Whether tails decrease so slowly that even twice the highest order would not suffice, so that no
/// higher order is tried.
bool IsHopeless(const std::array<std::vector<long double>, 3>& tails, const Orders& trial,
  const std::array<bool, 3>& varies, double target, int most)
{
  for (std::size_t d = 0; d < 3; ++d)
  {
    const long double first = tails[d][1];
    const long double last = tails[d][static_cast<std::size_t>(trial[d])];
    if (varies[d] && last > target && trial[d] > 1)
    {
      const long double steps =
        (trial[d] - 1) * std::log(target / first) / std::log(std::min(last / first, 0.999L));
      if (steps > 2 * most)
      {
        return true;
      }
    }
  }
  return false;
}

/// For each direction and index, the sum of |coefficient| over all coefficients with at least this
/// index; the largest of all components.
std::array<Grid, 3> TailsOf(const std::vector<Grid>& legendre, const GridSize& size)
{
  std::array<Grid, 3> tails;
  for (std::size_t d = 0; d < 3; ++d)
  {
    tails[d].resize(static_cast<std::size_t>(size[d]) + 1, 0.0L);
  }
  for (const Grid& grid : legendre)
  {
    std::array<Grid, 3> own;
    for (std::size_t d = 0; d < 3; ++d)
    {
      own[d].resize(tails[d].size(), 0.0L);
    }
    const auto n1 = static_cast<std::size_t>(size[1]);
    const auto n2 = static_cast<std::size_t>(size[2]);
    for (std::size_t i = 0; i < grid.size(); ++i)
    {
      const long double magnitude = std::fabs(grid[i]);
      own[0][i / (n1 * n2)] += magnitude;
      own[1][i / n2 % n1] += magnitude;
      own[2][i % n2] += magnitude;
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      long double sum = 0.0L;
      for (std::size_t k = own[d].size(); k-- > 0;)
      {
        sum += own[d][k];
        tails[d][k] = std::max(tails[d][k], sum);
      }
    }
  }
  return tails;
}
} // namespace

double ExtentOf(const RationalElement& element)
{
  const std::size_t points = element.weights.size();
  double extent = 0.0;
  for (int c = 0; c < element.Components(); ++c)
  {
    long double low = std::numeric_limits<long double>::infinity();
    long double high = -low;
    for (std::size_t i = 0; i < points; ++i)
    {
      const long double x =
        element.numerators[static_cast<std::size_t>(c) * points + i] / element.weights[i];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    extent = std::max(extent, static_cast<double>(high - low));
  }
  return extent;
}

bool VariesAlong(const RationalElement& element, std::size_t direction)
{
  const GridSize size = SizeOf(element.degree);
  std::size_t stride = 1;
  for (std::size_t k = direction + 1; k < 3; ++k)
  {
    stride *= static_cast<std::size_t>(size[k]);
  }
  const std::size_t line = stride * static_cast<std::size_t>(size[direction]);
  for (std::size_t i = 0; i < element.weights.size(); ++i)
  {
    const long double first = element.weights[i - i % line + i % stride];
    if (std::fabs(element.weights[i] - first) > kSameWeights * first)
    {
      return true;
    }
  }
  return false;
}

void NodeValues(
  const RationalElement& element, const Orders& order, LineTables& tables, std::span<double> values)
{
  const std::vector<Grid> ratios = Ratios(element, ToNodes(element, order, tables));
  auto out = values.begin();
  for (int c = 0; c < element.Components(); ++c)
  {
    for (const long double ratio : ratios[static_cast<std::size_t>(c)])
    {
      *out++ = static_cast<double>(element.shift[static_cast<std::size_t>(c)] + ratio);
    }
  }
}

double LossOf(const RationalElement& element, const Orders& order, LineTables& tables)
{
  const bool holds =
    order[0] >= element.degree[0] && order[1] >= element.degree[1] && order[2] >= element.degree[2];
  if (element.isPolynomial && holds)
  {
    return 0.0;
  }
  const Lines nodes = ToNodes(element, order, tables);
  Lines toSamples{};
  Lines fromNodes{};
  long double factor = 1.0L;   // of Ehlich and Zeller
  long double lebesgue = 1.0L; // what interpolation makes of rounding
  int terms = 0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int degree = element.degree[d] + order[d];
    const int samples = degree == 0 ? 1 : std::max(degree + 1, (3 * degree + 1) / 2);
    factor /= std::cos(std::numbers::pi_v<long double> * degree / (2 * samples));
    toSamples[d] = &tables.BernsteinToSamples(element.degree[d], samples);
    fromNodes[d] = &tables.NodesToSamples(order[d], samples);
    lebesgue *= fromNodes[d]->Norm();
    terms += 8 * (element.degree[d] + order[d] + 2);
  }
  const auto [least, most] = std::ranges::minmax(element.weights);
  const Grid weights = Evaluate(element.weights, element.degree, toSamples);
  const std::vector<Grid> atNodes = Ratios(element, nodes);
  const std::vector<Grid> exact = Ratios(element, toSamples);
  long double loss = 0.0L;
  for (int c = 0; c < element.Components(); ++c)
  {
    const auto at = static_cast<std::size_t>(c);
    long double largest = 0.0L; // of |N / w|: a mean of the points with positive weights
    const auto numerator = Numerator(element, c);
    for (std::size_t i = 0; i < numerator.size(); ++i)
    {
      largest = std::max(largest, std::fabs(numerator[i]) / element.weights[i]);
    }
    // Sums of positive multiples of the weights, and of bounds of |N|: each of the chained
    // roundings counts at most `largest` times the ratio of the weights.
    const long double rounding =
      terms * kLongRoundoff * largest * (most / least) * (1 + lebesgue) * (1 + 1e-12L);
    const Grid polynomial = Evaluate(atNodes[at], order, fromNodes);
    for (std::size_t i = 0; i < polynomial.size(); ++i)
    {
      loss = std::max(loss, weights[i] * (std::fabs(exact[at][i] - polynomial[i]) + rounding));
    }
  }
  return static_cast<double>(factor * loss / least) * (1 + 1e-12);
}

OrderEstimate EstimateOrders(
  const RationalElement& element, double target, int most, LineTables& tables)
{
  constexpr std::array kExtra{ 4, 8, 16, kMaxOrder };
  if (element.isPolynomial)
  {
    return { element.degree, 0 };
  }
  const std::array<bool, 3> varies{ VariesAlong(element, 0), VariesAlong(element, 1),
    VariesAlong(element, 2) };
  OrderEstimate found;
  for (const int extra : kExtra)
  {
    Orders trial = element.degree;
    bool isLast = true;
    Lines toLegendre{};
    for (std::size_t d = 0; d < 3; ++d)
    {
      // Two orders above the highest are needed to check that the highest suffices.
      trial[d] += varies[d] ? extra : 0;
      isLast = isLast && (!varies[d] || trial[d] >= most + 2);
      trial[d] = std::min(trial[d], std::max(element.degree[d], std::min(most + 2, kMaxOrder)));
      toLegendre[d] = &tables.NodesToLegendre(trial[d]);
    }
    std::vector<Grid> legendre;
    for (const Grid& ratio : Ratios(element, ToNodes(element, trial, tables)))
    {
      legendre.push_back(Evaluate(ratio, trial, toLegendre));
    }
    const std::array<Grid, 3> tails = TailsOf(legendre, SizeOf(trial));
    Orders order = element.degree;
    bool isResolved = true;
    bool isWithin = true;
    long double worst = -1.0L;
    for (std::size_t d = 0; d < 3; ++d)
    {
      if (!varies[d])
      {
        continue;
      }
      const auto enough = [&](int q)
      { return tails[d][static_cast<std::size_t>(q) + 1] <= target / 8; };
      while (order[d] < trial[d] && !enough(order[d]))
      {
        ++order[d];
      }
      isResolved = isResolved && order[d] + 2 <= trial[d];
      isWithin = isWithin && order[d] <= std::max(most, element.degree[d]);
      const long double last = tails[d][static_cast<std::size_t>(trial[d])];
      if (last > worst)
      {
        worst = last;
        found.worst = static_cast<int>(d);
      }
    }
    if (IsHopeless(tails, trial, varies, target, most))
    {
      return found;
    }
    if (isResolved && isWithin)
    {
      found.order = order;
      return found;
    }
    if (isLast)
    {
      return found;
    }
  }
  return found;
}
} // namespace pixelexact::rational
