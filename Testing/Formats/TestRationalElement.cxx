// SPDX-License-Identifier: BSD-3-Clause
// The proven bound of what polynomials lose of rational functions.
#include "Formats/Rational/LineMatrix.h"
#include "Formats/Rational/RationalElement.h"
#include "Formats/Rational/SimplexElement.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// The value by the definition.
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

/// A prism or tetrahedron of degree 2 with weights between 1 and 1.5, as a function of eta.
RationalElement RandomSimplex(const pixelexact::Space& space, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::uniform_real_distribution<double> weight(1.0, 1.5);
  std::vector<long double> weights;
  std::vector<long double> numerators;
  for (int i = 0; i < space.Modes(); ++i)
  {
    weights.push_back(weight(random));
    numerators.push_back(weights.back() * value(random));
  }
  return { { space.order[0], space.order[1], space.order[2] }, Collapse(space, weights),
    Collapse(space, numerators), { 0.25L }, false };
}

TEST(SimplexElement, CollapsedFunctionsAreBernsteins)
{
  const pixelexact::Space space{ pixelexact::Shape::Tetrahedron, pixelexact::Form::Collapsed,
    { 2, 2, 2 } };
  // Numbered by (i, j, k), k fastest.
  std::vector<long double> control(10);
  std::mt19937 random(2);
  std::ranges::generate(control, [&] { return random() % 1000 / 1000.0L; });
  RationalElement element{ { 2, 2, 2 }, std::vector<long double>(27, 1.0L),
    Collapse(space, control), { 0.0L }, false };
  for (const std::array<long double, 3>& eta :
    { std::array{ 0.3L, -0.2L, 0.5L }, std::array{ -0.7L, 0.9L, -0.4L } })
  {
    const long double l3 = (1 + eta[2]) / 2;
    const long double l2 = (1 + eta[1]) / 2 * (1 - l3);
    const long double l1 = (1 + eta[0]) / 2 * (1 - l2 - l3);
    const long double l0 = 1 - l1 - l2 - l3;
    long double sum = 0.0L;
    std::size_t at = 0;
    const auto power = [](long double x, int n) { return n == 0 ? 1.0L : n == 1 ? x : x * x; };
    for (int i = 0; i <= 2; ++i)
    {
      for (int j = 0; i + j <= 2; ++j)
      {
        for (int k = 0; i + j + k <= 2; ++k, ++at)
        {
          const int rest = 2 - i - j - k;
          const int twice = i == 2 || j == 2 || k == 2 || rest == 2 ? 1 : 2;
          sum += twice * control[at] * power(l1, i) * power(l2, j) * power(l3, k) * power(l0, rest);
        }
      }
    }
    EXPECT_NEAR(static_cast<double>(ValueAt(element, eta)), static_cast<double>(sum), 1e-16);
  }
}

TEST(SimplexElement, TheBoundHoldsAndIsSharp)
{
  using pixelexact::Form;
  using pixelexact::Shape;
  using pixelexact::Space;
  for (const Shape shape : { Shape::Prism, Shape::Tetrahedron })
  {
    const Space given = pixelexact::UniformSpace(shape, 2);
    for (const int order : { 3, 6, 8 })
    {
      const SimplexBasis basis(pixelexact::UniformSpace(shape, order));
      LineTables tables;
      const RationalElement element = RandomSimplex(given, 7);
      const double loss = basis.LossOf(element, tables);
      std::vector<double> values(static_cast<std::size_t>(basis.GetSpace().Modes()));
      std::vector<double> modes(values.size());
      basis.NodeValues(element, values);
      basis.GetChange().Apply(values, 0.25, modes);
      std::vector<long double> places;
      for (int i = 0; i <= 24; ++i)
      {
        places.push_back(-1.0L + i / 12.0L);
      }
      const auto found =
        CollapsedModes(basis.GetSpace(), { places, places, places }).Evaluate(modes);
      double error = 0.0;
      auto at = found.value.begin();
      for (const long double e1 : places)
      {
        for (const long double e2 : places)
        {
          for (const long double e3 : places)
          {
            const long double exact = ValueAt(element, { e1, e2, e3 });
            error = std::max(error, static_cast<double>(std::fabs(exact - 0.25L - *at++)));
          }
        }
      }
      EXPECT_LE(error, loss) << Name(shape) << " " << order;
      EXPECT_GE(error, loss / 20) << Name(shape) << " " << order;
    }
  }
}
} // namespace
