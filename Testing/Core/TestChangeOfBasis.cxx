// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Base/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace pixelexact::testing
{
namespace
{
/// A polynomial of the given orders in xi: (1 + 0.3 a)^p (1 - 0.2 b)^q (1 + 0.1 c)^r, spread over
/// the directions so that its total degree is no more than the order where that is needed.
long double Manufactured(const Space& space, const LongVec3& xi)
{
  const auto [p, q, r] = space.order;
  const long double linear = 1 + 0.3L * xi[0] - 0.2L * xi[1] + 0.1L * xi[2];
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return std::pow(1 + 0.3L * xi[0], p) * std::pow(1 - 0.2L * xi[1], q) *
        std::pow(1 + 0.1L * xi[2], r);
    case Shape::Prism:
      return std::pow(1 + 0.3L * xi[0] + 0.1L * xi[2], p) * std::pow(1 - 0.2L * xi[1], q);
    default:
      return std::pow(linear, p);
  }
}

std::vector<int> Identity(int count)
{
  std::vector<int> source(count);
  std::iota(source.begin(), source.end(), 0);
  return source;
}

long double At(const Space& space, const std::vector<double>& modes, const LongVec3& xi)
{
  std::vector<long double> values(space.Modes());
  EvaluateModes(space, xi, values.data());
  long double sum = 0.0L;
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    sum += modes[k] * values[k];
  }
  return sum;
}

void ExpectReproduced(const Space& space, const ChangeOfBasis& change,
  const std::vector<double>& nodal, double tolerance)
{
  std::vector<double> modes(space.Modes());
  change.Apply(nodal, 0.0, modes);
  Random random(7);
  for (int trial = 0; trial < 20; ++trial)
  {
    const LongVec3 xi = ToLong(random.Inside(space.shape));
    EXPECT_NEAR(static_cast<double>(At(space, modes, xi) - Manufactured(space, xi)), 0.0, tolerance)
      << Name(space.shape) << " order " << space.MaxOrder();
  }
}

/// Rounding of the node values times the order's amplification, from the change of basis itself.
double Tolerance(const ChangeOfBasis& change, double largest)
{
  const auto amplification = change.Amplification();
  return 2e-16 * largest * std::accumulate(amplification.begin(), amplification.end(), 10.0);
}
} // namespace

TEST(ChangeOfBasis, LagrangeHexahedronWithOrdersOfItsOwn)
{
  for (const std::array<std::uint8_t, 3> order :
    { std::array<std::uint8_t, 3>{ 1, 1, 1 }, { 2, 3, 5 }, { 6, 6, 6 }, { 10, 10, 10 } })
  {
    const Space space{ Shape::Hexahedron, Form::Collapsed, order };
    std::vector<double> nodal;
    for (int i = 0; i <= order[0]; ++i)
    {
      for (int j = 0; j <= order[1]; ++j)
      {
        for (int k = 0; k <= order[2]; ++k)
        {
          nodal.push_back(static_cast<double>(Manufactured(
            space, { 2.0L * i / order[0] - 1, 2.0L * j / order[1] - 1, 2.0L * k / order[2] - 1 })));
        }
      }
    }
    const auto change =
      ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, Identity(space.Modes()));
    ExpectReproduced(space, change, nodal, Tolerance(change, 20.0));
  }
}

TEST(ChangeOfBasis, LagrangePrismAndTetrahedron)
{
  for (const int n : { 1, 2, 3, 5, 8 })
  {
    const auto order = static_cast<std::uint8_t>(n);
    const Space prism{ Shape::Prism, Form::Collapsed, { order, 4, order } };
    std::vector<double> nodal;
    for (int i = 0; i <= n; ++i)
    {
      for (int k = 0; k <= n - i; ++k)
      {
        for (int j = 0; j <= 4; ++j)
        {
          nodal.push_back(static_cast<double>(
            Manufactured(prism, { 2.0L * i / n - 1, 2.0L * j / 4 - 1, 2.0L * k / n - 1 })));
        }
      }
    }
    const auto change =
      ChangeOfBasis::Prism(prism, Family::EquispacedLagrange, Identity(prism.Modes()));
    ExpectReproduced(prism, change, nodal, Tolerance(change, 10.0));

    const Space tetrahedron = UniformSpace(Shape::Tetrahedron, n);
    nodal.clear();
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n - i; ++j)
      {
        for (int k = 0; k <= n - i - j; ++k)
        {
          nodal.push_back(static_cast<double>(
            Manufactured(tetrahedron, { 2.0L * i / n - 1, 2.0L * j / n - 1, 2.0L * k / n - 1 })));
        }
      }
    }
    const auto simplex = ChangeOfBasis::Tetrahedron(
      tetrahedron, Family::EquispacedLagrange, Identity(tetrahedron.Modes()));
    ExpectReproduced(tetrahedron, simplex, nodal, Tolerance(simplex, 10.0));
  }
}

TEST(ChangeOfBasis, BernsteinSumsToOneAndReproducesLinears)
{
  // Bernstein coefficients of a linear function are its values at the equispaced points.
  for (const int n : { 1, 2, 4, 7 })
  {
    const Space space = UniformSpace(Shape::Tetrahedron, n);
    std::vector<double> control;
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n - i; ++j)
      {
        for (int k = 0; k <= n - i - j; ++k)
        {
          control.push_back(3.0 + 2.0 * i / n - 1.0 * j / n + 0.5 * k / n);
        }
      }
    }
    std::vector<double> modes(space.Modes());
    ChangeOfBasis::Tetrahedron(space, Family::Bernstein, Identity(space.Modes()))
      .Apply(control, 0.0, modes);
    Random random(5);
    for (int trial = 0; trial < 20; ++trial)
    {
      const Vec3 xi = random.Inside(space.shape);
      EXPECT_NEAR(static_cast<double>(At(space, modes, ToLong(xi))),
        3.0 + (1.0 + xi.x) - 0.5 * (1.0 + xi.y) + 0.25 * (1.0 + xi.z), 1e-14 * std::exp2(n));
    }
  }
}

TEST(ChangeOfBasis, ShiftIsSubtractedBeforeRounding)
{
  // Nodes near 1e8 that differ by 1e-7: their modes must carry the difference, not its rounding.
  const Space space = UniformSpace(Shape::Hexahedron, 1);
  const double far = 1e8;
  std::vector<double> nodal(8, far);
  nodal[7] = far + 0x1p-20;
  std::vector<double> modes(8);
  ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, Identity(8))
    .Apply(nodal, far, modes);
  EXPECT_EQ(modes[0], 0x1p-23);
}

TEST(ChangeOfBasis, RefusesFunctionsOutsideTheSpaceAndNumberingsThatAreNone)
{
  const Space space = UniformSpace(Shape::Hexahedron, 1);
  EXPECT_THROW(ChangeOfBasis::FromFunctions(
                 space, 1, [](const LongVec3& xi, long double* v) { *v = xi[0] * xi[0]; }),
    InvalidData);
  std::vector<int> twice(8, 0);
  EXPECT_THROW(ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, twice), InvalidData);
}

TEST(ChangeOfBasis, AllShapesHoldTheCurvedMap)
{
  for (const Shape shape : kShapes)
  {
    const Space space = UniformSpace(shape, 3);
    const auto change = ChangeOfBasis::FromFunctions(
      space, 1, [](const LongVec3& xi, long double* v) { *v = Curved(xi)[1]; });
    std::vector<double> modes(space.Modes());
    change.Apply(std::vector<double>{ 1.0 }, 0.0, modes);
    Random random(11);
    for (int trial = 0; trial < 50; ++trial)
    {
      const LongVec3 xi = ToLong(random.Inside(shape));
      EXPECT_NEAR(static_cast<double>(At(space, modes, xi) - Curved(xi)[1]), 0.0, 1e-15);
    }
  }
}
TEST(LineFunctions, GaussRulesAreTheRootsOfLegendre)
{
  // Closed forms for few points; for many, the recurrence's own value at the roots.
  const auto lobatto = GaussLobattoPoints(5);
  EXPECT_NEAR(static_cast<double>(lobatto[1] + std::sqrt(3.0L / 7)), 0.0, 1e-18);
  EXPECT_EQ(lobatto[2], 0.0L);
  const auto gauss = GaussPoints(4);
  EXPECT_NEAR(
    static_cast<double>(gauss[0] + std::sqrt(3.0L / 7 + 2.0L / 7 * std::sqrt(1.2L))), 0.0, 1e-18);
  for (const int n : { 1, 2, 7, 16, 33 })
  {
    const auto points = GaussPoints(n);
    ASSERT_TRUE(std::ranges::is_sorted(points));
    for (const long double z : points)
    {
      EXPECT_NEAR(static_cast<double>(std::legendre(n, z)), 0.0, 1e-16);
    }
  }
}

TEST(LineFunctions, LagrangeIsNodalAndBernsteinSumsToOne)
{
  const auto points = GaussLobattoPoints(9);
  const LineFunctions lagrange = Lagrange(points);
  std::vector<long double> values(9);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lagrange.evaluate(points[i], values.data());
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      EXPECT_NEAR(static_cast<double>(values[j]), i == j ? 1.0 : 0.0, 1e-18);
    }
  }
  values.resize(21);
  Bernstein(20).evaluate(0.3L, values.data());
  EXPECT_NEAR(
    static_cast<double>(std::accumulate(values.begin(), values.end(), -1.0L)), 0.0, 1e-18);
}

TEST(ChangeOfBasis, LinesOfGaussPointsReproduceAHexahedron)
{
  const Space space{ Shape::Hexahedron, Form::Collapsed, { 3, 5, 8 } };
  std::array<std::vector<long double>, 3> points;
  std::array<LineFunctions, 3> lines;
  for (int d = 0; d < 3; ++d)
  {
    points[d] = d == 1 ? GaussPoints(space.order[d] + 1) : GaussLobattoPoints(space.order[d] + 1);
    lines[d] = Lagrange(points[d]);
  }
  std::vector<double> nodal;
  for (const auto a : points[0])
  {
    for (const auto b : points[1])
    {
      for (const auto c : points[2])
      {
        nodal.push_back(static_cast<double>(Manufactured(space, { a, b, c })));
      }
    }
  }
  const auto change =
    ChangeOfBasis::FromLines(space, lines, Identity(static_cast<int>(nodal.size())));
  ExpectReproduced(space, change, nodal, Tolerance(change, 4.0));
  EXPECT_THROW(ChangeOfBasis::FromLines(UniformSpace(Shape::Hexahedron, 3), lines,
                 Identity(static_cast<int>(nodal.size()))),
    InvalidData);
}

TEST(ChangeOfBasis, TriangleTimesLineReproducesAPrism)
{
  // Monomials on the triangle, Bernstein's polynomials on the line.
  const Space space{ Shape::Prism, Form::Collapsed, { 2, 3, 2 } };
  const auto change = ChangeOfBasis::FromTriangleAndLine(
    space, 6,
    [](long double a, long double c, long double* v)
    {
      const long double monomials[6] = { 1, a, c, a * a, a * c, c * c };
      std::copy(monomials, monomials + 6, v);
    },
    Bernstein(3), Identity(24));
  // (a c) ((1 + b) / 2)^3
  std::vector<double> source(24, 0.0);
  source[4 * 4 + 3] = 1.0;
  std::vector<double> modes(space.Modes());
  change.Apply(source, 0.0, modes);
  Random random(5);
  for (int trial = 0; trial < 20; ++trial)
  {
    const LongVec3 xi = ToLong(random.Inside(space.shape));
    const long double expected = xi[0] * xi[2] * std::pow((1 + xi[1]) / 2, 3);
    EXPECT_NEAR(static_cast<double>(At(space, modes, xi) - expected), 0.0, 1e-15);
  }
}

TEST(ChangeOfBasis, ProductsHaveMoreBitsThanLongDouble)
{
  Random random(3);
  for (const auto& [rows, columns, rest] :
    { std::array{ 1, 1, 1 }, { 4, 4, 16 }, { 20, 20, 3 }, { 9, 17, 5 } })
  {
    BasisFactor factor{ rows, columns, {} };
    for (int i = 0; i < rows * columns; ++i)
    {
      factor.matrix.push_back(1.0L / 3 + random(-1.0, 1.0));
    }
    PairBuffer from;
    PairBuffer to;
    from.Resize(static_cast<std::size_t>(columns * rest));
    for (int i = 0; i < columns * rest; ++i)
    {
      from.high[i] = random(-1.0, 1.0);
      from.low[i] = 0x1p-54 * from.high[i];
    }
    Multiply(PairMatrix(factor), static_cast<std::size_t>(rest), from, to);
    for (int r = 0; r < rest; ++r)
    {
      for (int row = 0; row < rows; ++row)
      {
        long double sum = 0.0L;
        for (int k = 0; k < columns; ++k)
        {
          const std::size_t at = static_cast<std::size_t>(k) * rest + r;
          sum += factor.matrix[static_cast<std::size_t>(row) * columns + k] *
            (static_cast<long double>(from.high[at]) + from.low[at]);
        }
        const std::size_t at = static_cast<std::size_t>(r) * rows + row;
        EXPECT_NEAR(static_cast<double>(sum - to.high[at] - to.low[at]), 0.0, 0x1p-60 * columns);
      }
    }
  }
}

TEST(ChangeOfBasis, ComponentsTogetherAreComponentsAlone)
{
  const Space space = UniformSpace(Shape::Prism, 4);
  const auto change =
    ChangeOfBasis::Prism(space, Family::EquispacedLagrange, Identity(space.Modes()));
  const auto count = static_cast<std::size_t>(space.Modes());
  const std::vector<double> shifts{ 0.25, -3.0, 1e9 };
  Random random(9);
  std::vector<double> values(3 * count);
  std::ranges::generate(values, [&random] { return random(-2.0, 2.0); });
  std::vector<double> together(3 * count);
  ChangeOfBasis::Scratch scratch;
  change.Apply(values, shifts, together, scratch);
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double> alone(count);
    change.Apply(std::span(values).subspan(c * count, count), shifts[c], alone);
    EXPECT_TRUE(std::ranges::equal(alone, std::span(together).subspan(c * count, count)));
  }
}

TEST(ChangeOfBasis, TakesTheLargestDoubles)
{
  const Space space = UniformSpace(Shape::Hexahedron, 2);
  const auto change =
    ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, Identity(space.Modes()));
  const double largest = std::numeric_limits<double>::max();
  std::vector<double> modes(27);
  change.Apply(std::vector<double>(27, largest), 0.0, modes);
  EXPECT_EQ(modes[0], largest);
  change.Apply(std::vector<double>(27, std::nan("")), 0.0, modes);
  EXPECT_TRUE(std::ranges::all_of(modes, [](double mode) { return std::isnan(mode); }));
}
} // namespace pixelexact::testing
