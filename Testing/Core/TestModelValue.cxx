// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/FunctionModel.h"
#include "Core/Expression/ModelValue.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

// Models of the operations of expressions, against long double at many points.
namespace pixelexact::testing
{
namespace
{
using Real = long double;

struct SmoothFunction
{
  std::string name;
  pixelexact::Operation operation;
  std::function<Real(Real)> exact;
  double middle; ///< of the argument
  double radius;
};

const std::vector<SmoothFunction>& SmoothFunctions()
{
  using enum pixelexact::Operation;
  static const std::vector<SmoothFunction> kAll{
    { "sqrt", Sqrt, [](Real v) { return std::sqrt(v); }, 2.0, 1.2 },
    { "exp", Exp, [](Real v) { return std::exp(v); }, -0.4, 2.0 },
    { "log", Log, [](Real v) { return std::log(v); }, 3.0, 1.5 },
    { "sin", Sin, [](Real v) { return std::sin(v); }, 1.4, 1.0 },
    { "cos", Cos, [](Real v) { return std::cos(v); }, 9.0, 1.0 },
    { "tan", Tan, [](Real v) { return std::tan(v); }, 0.3, 0.5 },
    { "asin", Asin, [](Real v) { return std::asin(v); }, 0.1, 0.5 },
    { "acos", Acos, [](Real v) { return std::acos(v); }, -0.2, 0.4 },
    { "atan", Atan, [](Real v) { return std::atan(v); }, 0.7, 0.6 },
    { "sinh", Sinh, [](Real v) { return std::sinh(v); }, 0.5, 1.0 },
    { "cosh", Cosh, [](Real v) { return std::cosh(v); }, -0.5, 1.0 },
    { "tanh", Tanh, [](Real v) { return std::tanh(v); }, 0.2, 0.6 },
    { "erf", Erf, [](Real v) { return std::erf(v); }, 0.3, 0.6 },
  };
  return kAll;
}

/// A model of middle + radius times a polynomial of (s, t) with values in [-1, 1], and its values.
struct Argument
{
  double middle;
  double radius;

  [[nodiscard]] ModelValue Model() const
  {
    const ChebyshevModel s = ChebyshevModel::First();
    const ChebyshevModel t = ChebyshevModel::Second();
    return ModelValue(
      ChebyshevModel(middle) + radius * (0.5 * (s * t) + 0.25 * (s * s) - 0.25 * (t * t * t)));
  }
  [[nodiscard]] Real At(Real s, Real t) const
  {
    return static_cast<Real>(middle) +
      static_cast<Real>(radius) * (0.5L * s * t + 0.25L * s * s - 0.25L * t * t * t);
  }
};

Real ModelAt(const ChebyshevModel& model, Real s, Real t)
{
  const auto chebyshev = [](int n, Real v)
  { return std::cos(static_cast<Real>(n) * std::acos(v)); };
  Real sum = 0.0L;
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      sum +=
        static_cast<Real>(model.c[ChebyshevModel::Index(i, j)]) * chebyshev(i, s) * chebyshev(j, t);
    }
  }
  return sum;
}

/// The largest difference over the model's error, at random points and at the corners.
Real WorstOver(const ModelValue& value, const std::function<Real(Real, Real)>& exact)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Real worst = 0.0L;
  for (int k = 0; k < 400; ++k)
  {
    const Real s = k < 4 ? (k % 2 == 0 ? -1.0L : 1.0L) : static_cast<Real>(coordinate(random));
    const Real t = k < 4 ? (k < 2 ? -1.0L : 1.0L) : static_cast<Real>(coordinate(random));
    const Real truth = exact(s, t);
    const Real off = std::fabs(truth - ModelAt(value.model, s, t));
    worst = std::max(worst, off / static_cast<Real>(value.model.error));
    // Long double has some rounding, too.
    constexpr Real kRounding = 1e-17L;
    EXPECT_GE(truth, static_cast<Real>(value.known.value.lower) - kRounding);
    EXPECT_LE(truth, static_cast<Real>(value.known.value.upper) + kRounding);
  }
  return worst;
}

Graph::Node OfArguments(pixelexact::Operation operation, std::array<int, 6> arguments)
{
  return { .operation = operation, .arguments = arguments };
}
constexpr std::array<int, 6> kOne{ 0, -1, -1, -1, -1, -1 };
constexpr std::array<int, 6> kTwo{ 0, 1, -1, -1, -1, -1 };

TEST(ModelValue, HoldsSmoothFunctions)
{
  for (const SmoothFunction& function : SmoothFunctions())
  {
    for (const double share : { 1.0, 0.25, 0.01 })
    {
      const Argument argument{ function.middle, share * function.radius };
      const ModelValue f = argument.Model();
      const ModelValue value =
        ApplyToModels(OfArguments(function.operation, kOne), std::span(&f, 1));
      ASSERT_TRUE(std::isfinite(value.model.error)) << function.name << " " << share;
      EXPECT_LE(
        WorstOver(value, [&](Real s, Real t) { return function.exact(argument.At(s, t)); }), 1.0L)
        << function.name << " " << share;
      // The error falls with the ninth power of the radius until it is rounding.
      EXPECT_LT(value.model.error,
        share == 1.0      ? 2e-2
          : share == 0.25 ? 1e-4
                          : 1e-10)
        << function.name << " " << share;
    }
  }
}

TEST(ModelValue, HoldsPowersQuotientsAndAngles)
{
  const Argument base{ 1.5, 0.5 };
  const Argument other{ -0.8, 0.3 };
  const std::array<ModelValue, 2> f{ base.Model(), other.Model() };
  const auto check = [&](pixelexact::Operation operation, const std::function<Real(Real, Real)>& of)
  {
    const ModelValue value = ApplyToModels(OfArguments(operation, kTwo), f);
    EXPECT_LT(value.model.error, 1e-2);
    EXPECT_LE(
      WorstOver(value, [&](Real s, Real t) { return of(base.At(s, t), other.At(s, t)); }), 1.0L)
      << static_cast<int>(operation);
  };
  using enum pixelexact::Operation;
  check(Divide, [](Real a, Real b) { return a / b; });
  check(Power, [](Real a, Real b) { return std::pow(a, b); });
  check(Atan2, [](Real a, Real b) { return std::atan2(a, b); });
  check(Multiply, [](Real a, Real b) { return a * b; });
  check(Min, [](Real a, Real b) { return std::min(a, b); });
  for (const double exponent : { 0.3, 2.5, 3.0, -2.0, -0.7 })
  {
    const std::array<ModelValue, 2> powers{ base.Model(), ModelValue(exponent) };
    const ModelValue value = ApplyToModels(OfArguments(Power, kTwo), powers);
    EXPECT_LT(value.model.error, 1e-3);
    EXPECT_LE(
      WorstOver(value,
        [&](Real s, Real t) { return std::pow(base.At(s, t), static_cast<Real>(exponent)); }),
      1.0L)
      << exponent;
  }
}

TEST(ModelValue, KnowsTheRangeAtKinksAndSteps)
{
  const Argument argument{ 0.1, 0.5 };
  const ModelValue f = argument.Model();
  using enum pixelexact::Operation;
  const std::pair<pixelexact::Operation, std::function<Real(Real)>> functions[] = {
    { Abs, [](Real v) { return std::fabs(v); } }, { Floor, [](Real v) { return std::floor(v); } },
    { Sign, [](Real v) { return v > 0.0L ? 1.0L
                           : v < 0.0L    ? -1.0L
                                         : 0.0L; } }
  };
  for (const auto& [operation, exact] : functions)
  {
    const ModelValue value = ApplyToModels(OfArguments(operation, kOne), std::span(&f, 1));
    EXPECT_TRUE(std::isfinite(value.model.error));
    EXPECT_LE(WorstOver(value, [&](Real s, Real t) { return exact(argument.At(s, t)); }), 1.0L);
  }
  // Where the sign is known, the model is as sharp as the argument's.
  const ModelValue above = Argument{ 0.6, 0.5 }.Model();
  EXPECT_LT(ApplyToModels(OfArguments(Abs, kOne), std::span(&above, 1)).model.error, 1e-13);
}

TEST(ModelValue, HasNoBoundWhereAFunctionIsNotDefined)
{
  const ModelValue f = Argument{ 0.1, 0.5 }.Model();
  using enum pixelexact::Operation;
  for (const pixelexact::Operation operation : { Sqrt, Log })
  {
    const ModelValue value = ApplyToModels(OfArguments(operation, kOne), std::span(&f, 1));
    EXPECT_FALSE(std::isfinite(value.model.error));
    EXPECT_TRUE(value.known.mayBeNaN);
  }
  EXPECT_FALSE(std::isfinite(Reciprocal(f).model.error));
}

TEST(ModelValue, HoldsEigenvalues)
{
  const std::array<Argument, 6> entries{ Argument{ 2.0, 0.2 }, { 0.5, 0.2 }, { -1.0, 0.3 },
    { 0.3, 0.1 }, { -0.2, 0.2 }, { 0.1, 0.1 } };
  std::vector<ModelValue> models;
  for (const Argument& entry : entries)
  {
    models.push_back(entry.Model());
  }
  for (int number = 0; number < 3; ++number)
  {
    Graph::Node node = OfArguments(pixelexact::Operation::Eigenvalue, { 0, 1, 2, 3, 4, 5 });
    node.a = number;
    const ModelValue value = ApplyToModels(node, models);
    EXPECT_LT(value.model.error, 1e-2) << number;
    EXPECT_LE(WorstOver(value,
                [&](Real s, Real t)
                {
                  std::array<Real, 6> m{};
                  std::ranges::transform(
                    entries, m.begin(), [&](const Argument& entry) { return entry.At(s, t); });
                  Eigen::Matrix<Real, 3, 3> matrix;
                  matrix << m[0], m[3], m[5], m[3], m[1], m[4], m[5], m[4], m[2];
                  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>>(matrix)
                    .eigenvalues()[2 - number];
                }),
      1.0L)
      << number;
  }
}

TEST(TaylorCoefficient, HoldsCoefficientsOfClosedForms)
{
  using enum pixelexact::Operation;
  const Interval x(0.2, 0.3);
  const auto expectHolds = [](const Interval& found, Real truth, std::size_t n)
  {
    EXPECT_LE(static_cast<Real>(found.lower), truth) << n;
    EXPECT_GE(static_cast<Real>(found.upper), truth) << n;
  };
  for (std::size_t n = 1; n <= 9; ++n)
  {
    const Real sign = n % 2 == 0 ? -1.0L : 1.0L;
    for (const double at : { 0.2, 0.25, 0.3 })
    {
      const Real power = std::pow(static_cast<Real>(at), static_cast<Real>(n));
      expectHolds(TaylorCoefficient(Log, 0.0, n, x), sign / (static_cast<Real>(n) * power), n);
      expectHolds(TaylorCoefficient(Power, -1.0, n, x), -sign / (power * static_cast<Real>(at)), n);
    }
  }
  EXPECT_FALSE(TaylorCoefficient(Log, 0.0, 9, Interval(-0.1, 0.2)).IsFinite());
  EXPECT_FALSE(TaylorCoefficient(Abs, 0.0, 9, x).IsFinite());
}
} // namespace
} // namespace pixelexact::testing
