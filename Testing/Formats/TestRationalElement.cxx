// SPDX-License-Identifier: BSD-3-Clause
// The proven bound of what polynomials lose of rational functions.
#include "Formats/Rational/RationalElement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pixelexact::rational;

/// Control points and weights by chance, the latter between 1 and `ratio`.
RationalElement Random(const Orders& degree, double ratio, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::uniform_real_distribution<double> weight(1.0, ratio);
  RationalElement element;
  element.degree = degree;
  element.shift = { 0.25L };
  for (int i = 0; i < (degree[0] + 1) * (degree[1] + 1) * (degree[2] + 1); ++i)
  {
    element.weights.push_back(weight(random));
    element.numerators.push_back(element.weights.back() * value(random));
  }
  return element;
}

long double Bernstein(int degree, int i, long double x)
{
  const long double t = (1 + x) / 2;
  return std::tgamma(degree + 1.0L) / (std::tgamma(i + 1.0L) * std::tgamma(degree - i + 1.0L)) *
    std::pow(t, i) * std::pow(1 - t, degree - i);
}

/// By the definition.
long double ValueAt(const RationalElement& element, const std::array<long double, 3>& x)
{
  long double numerator = 0.0L;
  long double weight = 0.0L;
  std::size_t at = 0;
  for (int i = 0; i <= element.degree[0]; ++i)
  {
    for (int j = 0; j <= element.degree[1]; ++j)
    {
      for (int k = 0; k <= element.degree[2]; ++k, ++at)
      {
        const long double b = Bernstein(element.degree[0], i, x[0]) *
          Bernstein(element.degree[1], j, x[1]) * Bernstein(element.degree[2], k, x[2]);
        numerator += b * element.numerators[at];
        weight += b * element.weights[at];
      }
    }
  }
  return element.shift[0] + numerator / weight;
}

/// The polynomial through the nodes' values, by Lagrange's formula.
long double PolynomialAt(
  const Orders& order, const std::vector<double>& values, const std::array<long double, 3>& x)
{
  std::array<LineMatrix, 3> lines;
  for (std::size_t d = 0; d < 3; ++d)
  {
    lines[d] = LagrangeAt(NodesOf(order[d]), { x[d] });
  }
  std::vector<long double> grid(values.begin(), values.end());
  GridSize size{ order[0] + 1, order[1] + 1, order[2] + 1 };
  for (int d = 0; d < 3; ++d)
  {
    Sweep(grid, size, d, lines[static_cast<std::size_t>(d)]);
  }
  return grid[0];
}

/// The largest difference on a lattice.
double MeasuredLoss(const RationalElement& element, const Orders& order)
{
  LineTables tables;
  std::vector<double> values(
    static_cast<std::size_t>((order[0] + 1) * (order[1] + 1) * (order[2] + 1)));
  NodeValues(element, order, tables, values);
  constexpr int kSteps = 10;
  long double worst = 0.0L;
  for (int i = 0; i <= kSteps; ++i)
  {
    for (int j = 0; j <= kSteps; ++j)
    {
      for (int k = 0; k <= (order[2] == 0 ? 0 : kSteps); ++k)
      {
        const std::array<long double, 3> x{ 2.0L * i / kSteps - 1, 2.0L * j / kSteps - 1,
          2.0L * k / kSteps - 1 };
        worst = std::max(worst, std::fabs(ValueAt(element, x) - PolynomialAt(order, values, x)));
      }
    }
  }
  return static_cast<double>(worst);
}

TEST(RationalElement, TheBoundHoldsAndIsSharp)
{
  LineTables tables;
  for (unsigned seed = 1; seed <= 2; ++seed)
  {
    for (const Orders degree : { Orders{ 2, 1, 0 }, Orders{ 3, 2, 0 }, Orders{ 2, 2, 2 } })
    {
      const RationalElement element = Random(degree, 3.0, seed);
      for (const int order : { 3, 5, 8 })
      {
        const Orders orders{ order, order, degree[2] == 0 ? 0 : order };
        const double proven = LossOf(element, orders, tables);
        const double measured = MeasuredLoss(element, orders);
        EXPECT_LE(measured, proven + 1e-15);
        EXPECT_LE(proven, 40 * measured) << order << " of degree " << degree[0];
      }
    }
  }
}

TEST(RationalElement, EstimatedOrdersAreEnough)
{
  LineTables tables;
  const double target = 1e-14;
  for (unsigned seed = 1; seed <= 2; ++seed)
  {
    const RationalElement element = Random({ 2, 2, 0 }, 1.5, seed);
    const OrderEstimate estimate = EstimateOrders(element, target, 24, tables);
    ASSERT_TRUE(estimate.order);
    EXPECT_EQ((*estimate.order)[2], 0);
    EXPECT_LE(LossOf(element, *estimate.order, tables), 4 * target);
    EXPECT_LE(MeasuredLoss(element, *estimate.order), 2 * target);
  }
  EXPECT_FALSE(EstimateOrders(Random({ 2, 2, 2 }, 1e6, 1), target, 12, tables).order);
}

TEST(RationalElement, WeightsAlongOneDirectionAskForOrdersAlongItAlone)
{
  LineTables tables;
  RationalElement element = Random({ 2, 2, 1 }, 1.5, 3);
  for (std::size_t i = 0; i < element.weights.size(); ++i)
  {
    const long double weight = 1.0L + 0.2L * static_cast<long double>(i / 6);
    element.numerators[i] *= weight / element.weights[i];
    element.weights[i] = weight;
  }
  const OrderEstimate estimate = EstimateOrders(element, 1e-13, 24, tables);
  ASSERT_TRUE(estimate.order);
  EXPECT_GT((*estimate.order)[0], 4);
  EXPECT_EQ((*estimate.order)[1], 2);
  EXPECT_EQ((*estimate.order)[2], 1);
}

TEST(RationalElement, PolynomialsLoseNothing)
{
  LineTables tables;
  RationalElement element = Random({ 3, 2, 1 }, 1.0, 5);
  element.isPolynomial = true;
  EXPECT_EQ(*EstimateOrders(element, 0.0, 12, tables).order, (Orders{ 3, 2, 1 }));
  EXPECT_EQ(LossOf(element, { 3, 2, 1 }, tables), 0.0);
  EXPECT_GT(LossOf(element, { 2, 2, 1 }, tables), 1e-3);
  EXPECT_LE(MeasuredLoss(element, { 3, 2, 1 }), 1e-15);
}
} // namespace
