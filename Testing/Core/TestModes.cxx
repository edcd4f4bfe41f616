// SPDX-License-Identifier: BSD-3-Clause
// The canonical modes against their closed form (Space.h), by explicit sums that share neither
// recurrence nor scaling with the code under test.
#include "MeshBuilder.h"

#include "Core/Element/Kernels.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
long double Binomial(int n, int k)
{
  long double b = 1.0L;
  for (int i = 1; i <= k; ++i)
  {
    b = b * (n - k + i) / i;
  }
  return b;
}

/// P_n^{(alpha,0)}(z) = sum over s of C(n+alpha, n-s) C(n, s) ((z-1)/2)^s ((z+1)/2)^{n-s}.
long double Jacobi(int alpha, int n, long double z)
{
  long double sum = 0.0L;
  for (int s = 0; s <= n; ++s)
  {
    sum += Binomial(n + alpha, n - s) * Binomial(n, s) * std::pow((z - 1) / 2, s) *
      std::pow((z + 1) / 2, n - s);
  }
  return sum;
}

long double ClosedForm(const Space& space, const LongVec3& eta, int p, int q, int r)
{
  const long double h2 = (1 - eta[1]) / 2;
  const long double h3 = (1 - eta[2]) / 2;
  const int m = std::max(p, q);
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return Jacobi(0, p, eta[0]) * Jacobi(0, q, eta[1]) * Jacobi(0, r, eta[2]);
    case Shape::Prism:
      return Jacobi(0, p, eta[0]) * Jacobi(0, q, eta[1]) * std::pow(h3, p) *
        Jacobi(2 * p + 1, r, eta[2]);
    case Shape::Tetrahedron:
      return Jacobi(0, p, eta[0]) * std::pow(h2, p) * Jacobi(2 * p + 1, q, eta[1]) *
        std::pow(h3, p + q) * Jacobi(2 * p + 2 * q + 2, r, eta[2]);
    default:
      return space.form == Form::Tensor
        ? Jacobi(0, p, eta[0]) * Jacobi(0, q, eta[1]) * Jacobi(0, r, eta[2])
        : Jacobi(0, p, eta[0]) * Jacobi(0, q, eta[1]) * std::pow(h3, m) *
          Jacobi(2 * m + 2, r, eta[2]);
  }
}

LongVec3 LongTensorToReference(Shape shape, const LongVec3& eta)
{
  const auto [a, b, c] = eta;
  const auto collapse = [](long double u, long double v) { return (1 + u) * (1 - v) / 2 - 1; };
  switch (shape)
  {
    case Shape::Hexahedron:
      return eta;
    case Shape::Prism:
      return { collapse(a, c), b, c };
    case Shape::Tetrahedron:
      return { (1 + a) * (1 - b) * (1 - c) / 4 - 1, collapse(b, c), c };
    default:
      return { collapse(a, c), collapse(b, c), c };
  }
}

std::vector<Space> MakeModeSpaces()
{
  std::vector<Space> spaces = MakeSpaces({ 0, 1, 2, 3, 4, 6, 8, 11, 16 });
  spaces.push_back({ Shape::Hexahedron, Form::Collapsed, { 3, 5, 7 } });
  spaces.push_back({ Shape::Prism, Form::Collapsed, { 2, 5, 4 } });
  spaces.push_back({ Shape::Tetrahedron, Form::Collapsed, { 2, 3, 5 } });
  spaces.push_back({ Shape::Pyramid, Form::Tensor, { 1, 2, 3 } });
  return spaces;
}

std::string Describe(const Space& space)
{
  return std::string(Name(space.shape)) + " form " + std::to_string(int(space.form)) + " order " +
    std::to_string(space.order[0]) + "," + std::to_string(space.order[1]) + "," +
    std::to_string(space.order[2]);
}

/// One point in all lanes, one mode sum.
struct OnePoint
{
  explicit OnePoint(const Vec3& xi)
  {
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(x[d], kLanePadding, xi[d]);
    }
  }
  [[nodiscard]] LanePoints Points() const { return { { x[0], x[1], x[2] }, 1 }; }
  double x[3][kLanePadding];
  double value[kLanePadding];
  double gradient[3][kLanePadding];
  double* valueTo[1] = { value };
  double* gradientTo[3] = { gradient[0], gradient[1], gradient[2] };
};
} // namespace

TEST(Modes, CountIsTheSpacesDimension)
{
  EXPECT_EQ(UniformSpace(Shape::Hexahedron, 3).Modes(), 64);
  EXPECT_EQ(UniformSpace(Shape::Prism, 3).Modes(), 40);
  EXPECT_EQ(UniformSpace(Shape::Tetrahedron, 3).Modes(), 20);
  EXPECT_EQ(UniformSpace(Shape::Pyramid, 3).Modes(), 30);
  for (const Space& space : MakeModeSpaces())
  {
    int visited = 0;
    ForEachMode(space, [&](int, int, int, int mode) { EXPECT_EQ(mode, visited++); });
    EXPECT_EQ(visited, space.Modes()) << Describe(space);
  }
}

TEST(Modes, ClosedFormInLongDouble)
{
  Random random(1);
  for (const Space& space : MakeModeSpaces())
  {
    std::vector<long double> modes(space.Modes());
    for (int trial = 0; trial < 20; ++trial)
    {
      const LongVec3 eta{ random(), random(), random() };
      EvaluateModes(space, LongTensorToReference(space.shape, eta), modes.data());
      ForEachMode(space,
        [&](int p, int q, int r, int mode)
        {
          const long double expected = ClosedForm(space, eta, p, q, r);
          EXPECT_NEAR(static_cast<double>(modes[mode] - expected), 0.0,
            1e-13 * (1.0 + std::fabs(static_cast<double>(expected))))
            << Describe(space) << " mode " << p << q << r;
        });
    }
  }
}

TEST(Modes, KernelValuesAgreeWithTheClosedForm)
{
  Random random(2);
  for (const Space& space : MakeModeSpaces())
  {
    const int modes = space.Modes();
    std::vector<double> coefficients(modes);
    for (int trial = 0; trial < 10; ++trial)
    {
      double scale = 0.0;
      const LongVec3 eta{ random(), random(), random() };
      const Vec3 xi = ToDouble(LongTensorToReference(space.shape, eta));
      // The closed form at the double that the kernel is given.
      const Vec3 at = ReferenceToTensor(space.shape, xi);
      long double expected = 0.0L;
      ForEachMode(space,
        [&](int p, int q, int r, int mode)
        {
          coefficients[mode] = random();
          const long double term = coefficients[mode] * ClosedForm(space, ToLong(at), p, q, r);
          expected += term;
          scale += std::fabs(static_cast<double>(term));
        });
      OnePoint point(xi);
      KernelsFor(space).value(space, coefficients.data(), 1, point.Points(), point.valueTo);
      EXPECT_NEAR(point.value[0], static_cast<double>(expected), 1e-13 * (scale + 1.0))
        << Describe(space);
    }
  }
}

TEST(Modes, KernelGradientsAgreeWithDifferencesInLongDouble)
{
  Random random(3);
  constexpr long double kStep = 1e-6L;
  for (const Space& space : MakeModeSpaces())
  {
    const int modes = space.Modes();
    std::vector<double> coefficients(modes);
    std::vector<long double> plus(modes);
    std::vector<long double> minus(modes);
    for (int trial = 0; trial < 5; ++trial)
    {
      for (double& c : coefficients)
      {
        c = random();
      }
      const Vec3 eta(random(-0.9, 0.9), random(-0.9, 0.9), random(-0.9, 0.9));
      const Vec3 xi = TensorToReference(space.shape, eta);
      OnePoint point(xi);
      KernelsFor(space).gradient(
        space, coefficients.data(), 1, point.Points(), point.valueTo, point.gradientTo);
      for (int d = 0; d < 3; ++d)
      {
        LongVec3 up = ToLong(xi);
        LongVec3 down = up;
        up[d] += kStep;
        down[d] -= kStep;
        EvaluateModes(space, up, plus.data());
        EvaluateModes(space, down, minus.data());
        long double expected = 0.0L;
        long double scale = 1.0L;
        for (int k = 0; k < modes; ++k)
        {
          const long double slope = coefficients[k] * (plus[k] - minus[k]) / (2 * kStep);
          expected += slope;
          scale += std::fabs(slope);
        }
        // Central differences: kStep^2 times the third derivative, at most order^6 / 10 here.
        const double order = space.MaxOrder() + 1.0;
        EXPECT_NEAR(point.gradient[d][0], static_cast<double>(expected),
          static_cast<double>(scale) * 1e-12 * std::pow(order, 4.0))
          << Describe(space) << " direction " << d;
      }
    }
  }
}

TEST(Modes, FiniteAtCollapsedVerticesAndEdges)
{
  for (const Shape shape : { Shape::Prism, Shape::Tetrahedron, Shape::Pyramid })
  {
    const Space space = UniformSpace(shape, 4);
    std::vector<double> coefficients(space.Modes(), 1.0);
    for (const Vec3& xi : { Vec3(-1.0, -1.0, 1.0), Vec3(-1.0, 1.0, -1.0), Vec3(-1.0, 0.5, 1.0) })
    {
      OnePoint point(xi);
      KernelsFor(space).gradient(
        space, coefficients.data(), 1, point.Points(), point.valueTo, point.gradientTo);
      EXPECT_TRUE(std::isfinite(point.value[0])) << Name(shape);
      for (const auto& component : point.gradient)
      {
        EXPECT_TRUE(std::isfinite(component[0])) << Name(shape);
      }
    }
  }
}
} // namespace pixelexact::testing
