// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Base/Error.h"

#include <gtest/gtest.h>

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
} // namespace pixelexact::testing
