// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBuilder.h"

#include "Core/Base/Error.h"
#include "Core/Expression/Expression.h"
#include "Core/Expression/Program.h"
#include "Core/Expression/SymmetricEigen.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Mat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

// Fields that are polynomials of x on a curved map, so that what expressions make of them is known
// in closed form; that is evaluated in long double.
namespace pixelexact::testing
{
namespace
{
using Reals = std::vector<long double>;
using Matrix = std::array<LongVec3, 3>;

LongVec3 Place(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { 5 + 0.25L * (a + 0.1L * b * b), -3 + 0.25L * (b + 0.08L * a * c),
    2 + 0.25L * (c + 0.06L * a * b) };
}

long double ScalarAt(const LongVec3& p)
{
  const auto [x, y, z] = p;
  return x * y + z * z - 2 * x + 1;
}
LongVec3 ScalarGradientAt(const LongVec3& p)
{
  const auto [x, y, z] = p;
  return { y - 2, x, 2 * z };
}
LongVec3 VectorAt(const LongVec3& p)
{
  const auto [x, y, z] = p;
  return { y * z + x * x, 2 * x * z - y * y, 3 * x * y + 2 * z };
}
/// Rows: of a component.
Matrix VectorGradientAt(const LongVec3& p)
{
  const auto [x, y, z] = p;
  return { LongVec3{ 2 * x, z, y }, LongVec3{ 2 * z, -2 * y, 2 * x },
    LongVec3{ 3 * y, 3 * x, 2.0L } };
}
Matrix SymmetricPart(const Matrix& m, long double sign)
{
  Matrix s{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      s[i][j] = (m[i][j] + sign * m[j][i]) / 2;
    }
  }
  return s;
}
long double SumOfSquares(const Matrix& m)
{
  long double sum = 0;
  for (const LongVec3& row : m)
  {
    for (const long double entry : row)
    {
      sum += entry * entry;
    }
  }
  return sum;
}
long double Det(const Matrix& m)
{
  const LongVec3 n = Cross(m[1], m[2]);
  return m[0][0] * n[0] + m[0][1] * n[1] + m[0][2] * n[2];
}
/// The roots of the characteristic polynomial (Cardano's formula in trigonometric form).
LongVec3 EigenvaluesOf(const Matrix& m)
{
  const long double mean = (m[0][0] + m[1][1] + m[2][2]) / 3;
  Matrix shifted = m;
  for (int i = 0; i < 3; ++i)
  {
    shifted[i][i] -= mean;
  }
  const long double p = std::sqrt(SumOfSquares(shifted) / 6);
  const long double half = std::clamp(Det(shifted) / (2 * p * p * p), -1.0L, 1.0L);
  const long double angle = std::acos(half) / 3;
  const long double turn = 2 * std::numbers::pi_v<long double> / 3;
  LongVec3 values{ mean + 2 * p * std::cos(angle), mean + 2 * p * std::cos(angle - turn),
    mean + 2 * p * std::cos(angle + turn) };
  std::ranges::sort(values, std::greater());
  return values;
}
long double VonMisesOf(const LongVec3& p)
{
  const Matrix strain = SymmetricPart(VectorGradientAt(p), 1);
  const long double trace = strain[0][0] + strain[1][1] + strain[2][2];
  Matrix s{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      s[i][j] = 2 * 0.7L * strain[i][j] + (i == j ? 1.3L * trace : 0);
    }
  }
  const auto [a, b, c] = EigenvaluesOf(s);
  return std::sqrt(((a - b) * (a - b) + (b - c) * (b - c) + (c - a) * (c - a)) / 2);
}

struct Case
{
  std::string text;
  std::function<Reals(const LongVec3&)> exact;
};

Reals All(const LongVec3& v)
{
  return { v[0], v[1], v[2] };
}
Reals All(const Matrix& m)
{
  Reals all;
  for (const LongVec3& row : m)
  {
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

std::vector<Case> Cases()
{
  using P = const LongVec3&;
  return {
    { "u", [](P p) { return Reals{ ScalarAt(p) }; } },
    { "2*u - x/y + z^3 - -1",
      [](P p) { return Reals{ 2 * ScalarAt(p) - p[0] / p[1] + p[2] * p[2] * p[2] + 1 }; } },
    { "-x^2", [](P p) { return Reals{ -p[0] * p[0] }; } },
    { "2^-x", [](P p) { return Reals{ std::pow(2.0L, -p[0]) }; } },
    { "x^2^0.5", [](P p) { return Reals{ std::pow(p[0], std::sqrt(2.0L)) }; } },
    { "u - sin(pi*x)*cos(pi*y)",
      [](P p)
      {
        constexpr long double kPi = std::numbers::pi_v<long double>;
        return Reals{ ScalarAt(p) - std::sin(kPi * p[0]) * std::cos(kPi * p[1]) };
      } },
    { "sqrt(u^2+1) + exp(x/9) + log(x) + erf(z/3) + tanh(y) + atan2(y, x)",
      [](P p)
      {
        const long double u = ScalarAt(p);
        return Reals{ std::sqrt(u * u + 1) + std::exp(p[0] / 9) + std::log(p[0]) +
          std::erf(p[2] / 3) + std::tanh(p[1]) + std::atan2(p[1], p[0]) };
      } },
    { "where(x > 5 && y < -2, u, 3)",
      [](P p) { return Reals{ p[0] > 5 && p[1] < -2 ? ScalarAt(p) : 3 }; } },
    { "min(x, y, z) + max(u, 0) + abs(y) + sign(y)",
      [](P p) { return Reals{ p[1] + std::max(ScalarAt(p), 0.0L) - p[1] - 1 }; } },
    { "v", [](P p) { return All(VectorAt(p)); } },
    { "v.x + v[1]*v.z",
      [](P p) { return Reals{ VectorAt(p)[0] + VectorAt(p)[1] * VectorAt(p)[2] }; } },
    { "mag(v)",
      [](P p)
      {
        const auto [a, b, c] = VectorAt(p);
        return Reals{ std::sqrt(a * a + b * b + c * c) };
      } },
    { "dot(v, coords)",
      [](P p)
      { return Reals{ VectorAt(p)[0] * p[0] + VectorAt(p)[1] * p[1] + VectorAt(p)[2] * p[2] }; } },
    { "cross(v, grad(u))", [](P p) { return All(Cross(VectorAt(p), ScalarGradientAt(p))); } },
    { "grad(u)", [](P p) { return All(ScalarGradientAt(p)); } },
    { "grad(v)", [](P p) { return All(VectorGradientAt(p)); } },
    { "grad(v)*v",
      [](P p)
      {
        Reals product;
        for (const LongVec3& row : VectorGradientAt(p))
        {
          product.push_back(
            row[0] * VectorAt(p)[0] + row[1] * VectorAt(p)[1] + row[2] * VectorAt(p)[2]);
        }
        return product;
      } },
    { "grad(v)[2, 0]", [](P p) { return Reals{ 3 * p[1] }; } },
    { "div(v)", [](P p) { return Reals{ 2 * p[0] - 2 * p[1] + 2 }; } },
    { "curl(v)",
      [](P p) {
        return Reals{ p[0], -2 * p[1], p[2] };
      } },
    { "vorticity(vec(v.x, v.y))", [](P p) { return Reals{ p[2] }; } },
    { "laplacian(u)", [](P) { return Reals{ 2 }; } },
    { "laplacian(v)",
      [](P) {
        return Reals{ 2, -2, 0 };
      } },
    { "hessian(u)",
      [](P) {
        return Reals{ 0, 1, 0, 1, 0, 0, 0, 0, 2 };
      } },
    { "tr(hessian(u*x))", [](P p) { return Reals{ 2 * p[0] + 2 * (p[1] - 2) }; } },
    { "grad(div(v))",
      [](P) {
        return Reals{ 2, -2, 0 };
      } },
    { "div(grad(u)*u)",
      [](P p)
      {
        const auto [a, b, c] = ScalarGradientAt(p);
        return Reals{ a * a + b * b + c * c + 2 * ScalarAt(p) };
      } },
    { "sym(grad(v))", [](P p) { return All(SymmetricPart(VectorGradientAt(p), 1)); } },
    { "strain(v)[0,2]", [](P p) { return Reals{ 2 * p[1] }; } },
    { "det(grad(v))", [](P p) { return Reals{ Det(VectorGradientAt(p)) }; } },
    { "Q(v)",
      [](P p)
      {
        const Matrix g = VectorGradientAt(p);
        return Reals{ (SumOfSquares(SymmetricPart(g, -1)) - SumOfSquares(SymmetricPart(g, 1))) /
          2 };
      } },
    { "eig(sym(grad(v)))",
      [](P p) { return All(EigenvaluesOf(SymmetricPart(VectorGradientAt(p), 1))); } },
    { "lambda2(v)",
      [](P p)
      {
        const Matrix s = SymmetricPart(VectorGradientAt(p), 1);
        const Matrix w = SymmetricPart(VectorGradientAt(p), -1);
        Matrix m{};
        for (int i = 0; i < 3; ++i)
        {
          for (int j = 0; j < 3; ++j)
          {
            for (int k = 0; k < 3; ++k)
            {
              m[i][j] += s[i][k] * s[k][j] + w[i][k] * w[k][j];
            }
          }
        }
        return Reals{ EigenvaluesOf(m)[1] };
      } },
    { "vonMises(v, 1.3, 0.7)", [](P p) { return Reals{ VonMisesOf(p) }; } },
    { "vonMises(1.3*tr(strain(v))*identity + 2*0.7*strain(v))",
      [](P p) { return Reals{ VonMisesOf(p) }; } },
    { "element + order(u) + t + Re", [](P) { return Reals{ 0 + 4 + 2.5L + 40 }; } },
    { "twice - 2*u", [](P) { return Reals{ 0 }; } },
  };
}

class Expression : public ::testing::TestWithParam<Shape>
{
protected:
  Expression()
    : OfU(1)
    , OfV(3)
  {
    Builder.Add(UniformSpace(GetParam(), 2), Place, Vec3(5.0, -3.0, 2.0), 0.25);
    const Space space = UniformSpace(GetParam(), 4);
    OfU.Add(space, [](const LongVec3& xi, long double* out) { *out = ScalarAt(Place(xi)); });
    OfV.Add(space,
      [](const LongVec3& xi, long double* out) { std::ranges::copy(VectorAt(Place(xi)), out); });
    Fields = { { "u", OfU.View() }, { "v", OfV.View() } };
    Scope.fields = Fields;
    Scope.time = 2.5;
    Scope.parameters["Re"] = 40.0;
    Scope.definitions["twice"] = "2*u";
    Scope.definitions["identity"] = "grad(coords)";
  }

  [[nodiscard]] Field Make(const std::string& text) const
  {
    Field field;
    field.name = text;
    field.function = MakeExpression(text, Scope);
    field.values.components = field.function->Components();
    return field;
  }

  [[nodiscard]] std::vector<Vec3> SomePoints(std::size_t count) const
  {
    Random random(7);
    std::vector<Vec3> xi(count);
    std::ranges::generate(xi, [&] { return 0.9 * random.Inside(GetParam()); });
    return xi;
  }

  MeshBuilder Builder;
  ExpansionBuilder OfU;
  ExpansionBuilder OfV;
  std::vector<Field> Fields;
  ExpressionScope Scope;
};
} // namespace

TEST_P(Expression, AreWhatClosedFormsAre)
{
  const std::vector<Vec3> xi = SomePoints(300); // more than are evaluated together
  for (const Case& one : Cases())
  {
    const Field field = Make(one.text);
    const auto components = static_cast<std::size_t>(field.values.components);
    std::vector<double> values(components * xi.size());
    EvaluateAt(Builder.View(), field, 0, xi, values, {});
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const Reals exact = one.exact(Place(ToLong(xi[k])));
      ASSERT_EQ(exact.size(), components) << one.text;
      for (std::size_t c = 0; c < components; ++c)
      {
        // Values are up to some hundred; second derivatives lose digits to the size of 0.25.
        EXPECT_NEAR(values[k * components + c], static_cast<double>(exact[c]), 2e-10)
          << one.text << " component " << c;
      }
    }
  }
}

// Gradients by the chain rule, against differences of values along each axis.
TEST_P(Expression, HaveTheGradientsThatDifferencesGive)
{
  const Mesh mesh = Builder.View();
  const std::vector<Vec3> xi = SomePoints(5);
  for (const Case& one : Cases())
  {
    const Field field = Make(one.text);
    const bool isOfThirdOrder = one.text.find("hessian") != std::string::npos ||
      one.text.find("laplacian") != std::string::npos || one.text.starts_with("grad(div") ||
      one.text.starts_with("div(grad");
    if (isOfThirdOrder)
    {
      EXPECT_THROW(field.function->RequireGradient(), Unsupported) << one.text;
      continue;
    }
    const auto components = static_cast<std::size_t>(field.values.components);
    std::vector<double> values(components * xi.size());
    std::vector<double> gradients(3 * values.size());
    EvaluateAt(mesh, field, 0, xi, values, gradients);
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const LongVec3 place = Place(ToLong(xi[k]));
      for (std::size_t d = 0; d < 3; ++d)
      {
        constexpr long double kStep = 1e-5L;
        LongVec3 before = place;
        LongVec3 after = place;
        before[d] -= kStep;
        after[d] += kStep;
        const Reals a = one.exact(before);
        const Reals b = one.exact(after);
        for (std::size_t c = 0; c < components; ++c)
        {
          const auto slope = static_cast<double>((b[c] - a[c]) / (2 * kStep));
          EXPECT_NEAR(gradients[3 * (k * components + c) + d], slope, 1e-6 * (1 + std::fabs(slope)))
            << one.text << " component " << c << " direction " << d;
        }
      }
    }
  }
}

TEST_P(Expression, AreEnclosedByIntervals)
{
  const Mesh mesh = Builder.View();
  const std::vector<Vec3> xi = SomePoints(40);
  std::vector<Vec3> x(xi.size());
  MapForward(mesh, 0, xi, x);
  int open = 0;
  for (const Case& one : Cases())
  {
    const Field field = Make(one.text);
    const auto components = static_cast<std::size_t>(field.values.components);
    std::vector<double> lower(components * xi.size());
    std::vector<double> upper(lower.size());
    EncloseAt(mesh, field, 0, xi, x, lower, upper);
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      const Reals exact = one.exact(ToLong(x[k]));
      for (std::size_t c = 0; c < components; ++c)
      {
        const double least = lower[k * components + c];
        const double most = upper[k * components + c];
        EXPECT_LE(least, exact[c] + 1e-17L * std::fabs(exact[c])) << one.text;
        EXPECT_GE(most, exact[c] - 1e-17L * std::fabs(exact[c])) << one.text;
        if (!std::isfinite(least) || !std::isfinite(most))
        {
          ++open;
          const bool hasNone = one.text.find("hessian") != std::string::npos ||
            one.text.find("laplacian") != std::string::npos || one.text.starts_with("grad(div") ||
            one.text.starts_with("div(grad") || one.text.find("atan2") != std::string::npos ||
            one.text.starts_with("element");
          EXPECT_TRUE(hasNone) << one.text << " is not enclosed";
          continue;
        }
        EXPECT_LE(most - least, 1e-9 * (1 + std::fabs(most))) << one.text;
      }
    }
  }
  EXPECT_GT(open, 0);
}

// Constants are not folded where that rounds.
TEST_P(Expression, AreEnclosedWhereConstantsAreRounded)
{
  constexpr long double kLongPi = std::numbers::pi_v<long double>;
  const std::vector<std::pair<std::string, long double>> cases{ { "-pi", -kLongPi },
    { "2*pi", 2 * kLongPi }, { "pi-3", kLongPi - 3 }, { "abs(-pi)", kLongPi }, { "sin(-pi)", 0.0L },
    { "pi == 3.141592653589793", 0.0L }, { "1e-300*1e-300", 1e-600L },
    { "mag(vec(1e-200,0,0))", 1e-200L }, { "1/3", 1.0L / 3 }, { "exp(1000)", std::exp(1000.0L) } };
  const Mesh mesh = Builder.View();
  const std::vector<Vec3> xi = SomePoints(20);
  std::vector<Vec3> x(xi.size());
  MapForward(mesh, 0, xi, x);
  std::vector<double> lower(xi.size());
  std::vector<double> upper(xi.size());
  for (const auto& [text, exact] : cases)
  {
    EncloseAt(mesh, Make(text), 0, xi, x, lower, upper);
    EXPECT_LE(lower[0], exact) << text;
    EXPECT_GE(upper[0], exact) << text;
  }
  EncloseAt(mesh, Make("x"), 0, xi, x, lower, upper);
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    EXPECT_EQ(lower[k], x[k].x);
  }
}

TEST_P(Expression, KnowTheMap)
{
  const std::vector<Vec3> xi = SomePoints(20);
  const Field field = Make("vec(detJ, scaledJacobian, xi[1])");
  std::vector<double> values(3 * xi.size());
  EvaluateAt(Builder.View(), field, 0, xi, values, {});
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    const auto [a, b, c] = ToLong(xi[k]);
    // Columns of the Jacobian.
    const LongVec3 J[3] = { { 0.25L, 0.02L * c, 0.015L * b }, { 0.05L * b, 0.25L, 0.015L * a },
      { 0, 0.02L * a, 0.25L } };
    const LongVec3 n = Cross(J[1], J[2]);
    const long double determinant = J[0][0] * n[0] + J[0][1] * n[1] + J[0][2] * n[2];
    long double scaled = determinant;
    for (const LongVec3& column : J)
    {
      scaled /= std::hypot(column[0], column[1], column[2]);
    }
    EXPECT_NEAR(values[3 * k], static_cast<double>(determinant), 1e-15);
    EXPECT_NEAR(values[3 * k + 1], static_cast<double>(scaled), 1e-13);
    EXPECT_EQ(values[3 * k + 2], xi[k].y);
  }
}

TEST_P(Expression, TakeTheNormalOfASurface)
{
  const std::vector<Vec3> xi = SomePoints(200);
  std::vector<Vec3> normals;
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    normals.emplace_back(0.01 * static_cast<double>(k), 0.6, -0.8);
  }
  const Field field = Make("dot(grad(u), n) + normal.x");
  ASSERT_TRUE(field.function->NeedsNormals());
  std::vector<double> values(xi.size());
  EvaluateAt(Builder.View(), field, 0, xi, values, {}, { .x = {}, .normals = normals });
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    const LongVec3 slope = ScalarGradientAt(Place(ToLong(xi[k])));
    const LongVec3 n = ToLong(normals[k]);
    EXPECT_NEAR(values[k],
      static_cast<double>(slope[0] * n[0] + slope[1] * n[1] + slope[2] * n[2] + n[0]), 1e-11);
  }
  EXPECT_THROW(EvaluateAt(Builder.View(), field, 0, xi, values, {}), Unsupported);
}

// The leaves are values and derivatives in closed form instead of the kernels'.
TEST_P(Expression, ComputeFromGivenDerivatives)
{
  using Kind = pixelexact::Operation;
  const LongVec3 at = Place(ToLong(SomePoints(1).front()));
  const auto leafAt = [&at](const Graph::Node& leaf)
  {
    const auto c = static_cast<std::size_t>(leaf.component);
    const auto a = static_cast<std::size_t>(leaf.a);
    switch (leaf.operation)
    {
      case Kind::Coordinate:
        return static_cast<double>(at[a]);
      case Kind::Pi:
        return std::numbers::pi;
      case Kind::Value:
        return static_cast<double>(leaf.field == 0 ? ScalarAt(at) : VectorAt(at)[c]);
      case Kind::Slope:
        return static_cast<double>(
          leaf.field == 0 ? ScalarGradientAt(at)[a] : VectorGradientAt(at)[c][a]);
      default:
        return std::numeric_limits<double>::quiet_NaN();
    }
  };
  int computed = 0;
  for (const Case& one : Cases())
  {
    const auto expression = MakeExpression(one.text, Scope);
    ASSERT_EQ(expression->GetFields().size(), 2U);
    EXPECT_EQ(expression->GetFields()[1]->name, "v");
    const std::span<const Graph::Node> nodes = expression->GetProgram().Leaves();
    std::vector<double> given(nodes.size());
    std::ranges::transform(nodes, given.begin(), leafAt);
    if (std::ranges::any_of(given, [](double value) { return std::isnan(value); }))
    {
      continue; // needs second derivatives or the element
    }
    ++computed;
    std::vector<const double*> leaves(nodes.size());
    std::ranges::transform(given, leaves.begin(), [](const double& value) { return &value; });
    std::vector<double> values(static_cast<std::size_t>(expression->Components()));
    std::vector<double*> out(values.size());
    std::ranges::transform(values, out.begin(), [](double& value) { return &value; });
    std::vector<double> scratch;
    expression->GetProgram().Run(leaves, 1, out.data(), scratch);
    const Reals exact = one.exact(at);
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      EXPECT_NEAR(values[c], static_cast<double>(exact[c]), 1e-11) << one.text << " " << c;
    }
  }
  EXPECT_GT(computed, 25);
}

TEST_P(Expression, GiveNothingWhereThereIsNone)
{
  const Vec3 xi(-0.2);
  std::vector<double> value(3);
  EvaluateAt(Builder.View(), Make("vec(sqrt(y), u/(x-x), where(sqrt(y), 1, 2))"), 0,
    std::span(&xi, 1), value, {});
  EXPECT_TRUE(std::isnan(value[0]));
  EXPECT_FALSE(std::isfinite(value[1]));
  EXPECT_TRUE(std::isnan(value[2]));
}

INSTANTIATE_TEST_SUITE_P(Shapes, Expression, ::testing::ValuesIn(kShapes),
  [](const auto& one) { return std::string(Name(one.param)); });

namespace
{
/// The error message for a text in a scope of u, v and a field named x.
std::string MessageOf(const std::string& text)
{
  std::vector<Field> fields(4);
  fields[0].name = "u";
  fields[1].name = "v";
  fields[1].values.components = 3;
  fields[2].name = "x";
  fields[3].name = "my field";
  ExpressionScope scope;
  scope.fields = fields;
  scope.definitions["around"] = "around + 1";
  try
  {
    static_cast<void>(MakeExpression(text, scope));
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}
} // namespace

TEST(ExpressionText, IsRefusedWithItsPlaceAndRemedy)
{
  const std::map<std::string, std::string> messages{
    { "u +", "something is missing at the end\n  u +\n     ^" },
    { "mag(v", "something is missing at the end\n  mag(v\n       ^" },
    { "u $ 2", "'$' is not expected here\n  u $ 2\n    ^" },
    { "u < 1 < 2", "'<' is not expected here\n  u < 1 < 2\n        ^" },
    { "2 * q", "nothing is named 'q'" },
    { "vort(v)", "there is no function 'vort'" },
    { "x + 1", "write \"x\" with its quotes for the field, coords.x for the other\n  x + 1\n  ^" },
    { "sin(v)", "sin takes scalars, not a vector of 3 components" },
    { "u + v", "a scalar and a vector of 3 components do not add up\n  u + v\n    ^" },
    { "v * v", "write dot(a, b), cross(a, b) or outer(a, b)" },
    { "v[3]", "there is no number 3 in a vector of 3 components" },
    { "u.x", "a scalar has no .x" },
    { "v.w", "'w' is not expected here" },
    { "curl(u)", "curl takes vectors of 2 or 3 components" },
    { "eig(grad(v))", "sym(...) makes one" },
    { "dot(v)", "dot takes 2 arguments, not 1" },
    { "where(u, 1, v)", "where chooses between two of the same shape" },
    { "laplacian(grad(u))", "third derivatives of fields are not available" },
    { "grad(detJ)", "derivatives of the Jacobian are not available" },
    { "t", "the data have no time" },
    { "1e999", "is too large or too small for a number" },
    { "around", "'around' is defined by itself" },
    { std::string(5000, '1'), "more than 4096" },
    { std::string(70, '(') + "u" + std::string(70, ')'), "more than 64 brackets" },
    { std::string(70, '-') + "u", "more than 64 brackets, signs or powers" },
  };
  for (const auto& [text, message] : messages)
  {
    EXPECT_NE(MessageOf(text).find(message), std::string::npos)
      << text << " says: " << MessageOf(text);
  }
  EXPECT_EQ(MessageOf("\"my field\" + 'my field' + \"x\" + coords.x"), "");
}

TEST(ExpressionText, OfAnyKindIsReadOrRefused)
{
  const std::vector<std::string> seeds{ "mag(curl(vec(u, v.x, v[1])))", "where(u>=1e-3, -u^2, 'x')",
    "vonMises(v, 1.5, 2) + Q(v) - lambda2(v)", "hessian(u)[0,1] / det(grad(v))",
    "min(u, 2, abs(v.y)) && !(u == 1) || u != 2" };
  const std::string characters = "uvxyz019.,()[]+-*/^<>=!&|'\" \tegradmn#\\\x80";
  std::mt19937 random(3);
  const auto below = [&random](std::size_t n) { return random() % n; };
  int read = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t change = 0; change <= below(4); ++change)
    {
      const std::size_t at = below(text.size());
      switch (below(4))
      {
        case 0:
          text.erase(at, 1 + below(3));
          break;
        case 1:
          text.insert(at, 1, characters[below(characters.size())]);
          break;
        case 2:
          text[at] = characters[below(characters.size())];
          break;
        default:
          text.insert(at, seeds[below(seeds.size())]);
      }
      text += text.empty() ? "u" : "";
    }
    read += MessageOf(text).empty() ? 1 : 0;
  }
  EXPECT_GT(read, 30);
}

TEST(SymmetricEigen, FindsWhatRotationsHid)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 500; ++trial)
  {
    const std::array<double, 6> m{ any(random), any(random), any(random), any(random), any(random),
      trial % 5 == 0 ? 0.0 : any(random) };
    const SymmetricEigen eigen(m);
    const Mat3 matrix(m[0], m[3], m[5], m[3], m[1], m[4], m[5], m[4], m[2]);
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 v = eigen.Vector(k);
      const Vec3 off = matrix * v - eigen.Value(k) * v;
      EXPECT_LE(std::max({ std::fabs(off.x), std::fabs(off.y), std::fabs(off.z) }), 4e-15);
      EXPECT_NEAR(v.x * v.x + v.y * v.y + v.z * v.z, 1.0, 4e-15);
      EXPECT_GE(eigen.Value(std::max(0, k - 1)), eigen.Value(k));
    }
  }
}
} // namespace pixelexact::testing
