// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeCases.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Ranges.h"
#include "Core/Expression/Expression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Expressions of a field of noise on curved elements, in 113 bits: their ranges, and their bounds
// along edges and on parts of planes.
namespace pixelexact::testing
{
namespace
{
/// The values of an expression's leaves at a point.
struct Leaves
{
  QuadVec3 x;
  Quad u;
  QuadVec3 slope; ///< du / dx
};

Quad Root(const Quad& square)
{
  // One Newton step from the nearest double.
  const Quad root(std::sqrt(static_cast<double>(square)));
  return (root + square / root) / Quad(2.0);
}

struct Formula
{
  std::string text;
  std::function<Quad(const Leaves&)> truth;
  bool isSmooth = true;
  /// The scalar that bounds along edges and on planes are of (FieldFunction::JetValue), from the
  /// value; none: the value.
  std::function<Quad(const Quad&)> bounded{};
};

const std::vector<Formula>& Formulas()
{
  static const std::vector<Formula> all{
    { "u^2 + x*y", [](const Leaves& at) { return at.u * at.u + at.x[0] * at.x[1]; } },
    { "u / (6 + y)", [](const Leaves& at) { return at.u / (Quad(6.0) + at.x[1]); } },
    { "sqrt(u^2 + 0.5)", [](const Leaves& at) { return Root(at.u * at.u + Quad(0.5)); }, true,
      [](const Quad& value) { return value * value - Quad(0.5); } },
    { "3 - 0.5*mag(grad(u))",
      [](const Leaves& at)
      {
        return Quad(3.0) -
          Quad(0.5) *
          Root(at.slope[0] * at.slope[0] + at.slope[1] * at.slope[1] + at.slope[2] * at.slope[2]);
      },
      true,
      [](const Quad& value)
      {
        const Quad magnitude = Quad(2.0) * (Quad(3.0) - value);
        return magnitude * magnitude;
      } },
    { "grad(u).x", [](const Leaves& at) { return at.slope[0]; } },
    { "dot(grad(u), grad(u)) - u",
      [](const Leaves& at)
      {
        return at.slope[0] * at.slope[0] + at.slope[1] * at.slope[1] + at.slope[2] * at.slope[2] -
          at.u;
      } },
    { "abs(u) + z", [](const Leaves& at) { return Abs(at.u) + at.x[2]; }, false },
    { "min(u, 0.25*x)",
      [](const Leaves& at)
      {
        const Quad other = Quad(0.25) * at.x[0];
        return at.u < other ? at.u : other;
      },
      false },
    { "where(u > 0, u, 0.5)", [](const Leaves& at) { return Quad(0.0) < at.u ? at.u : Quad(0.5); },
      false },
  };
  return all;
}

struct ExpressionCase : EdgeCase
{
  ExpressionCase(
    Shape shape, int mapOrder, int fieldOrder, const Formula& itsFormula, Random& random)
    : EdgeCase(shape, mapOrder, fieldOrder, random)
    , formula(itsFormula)
  {
    field.name = "u";
    expression.name = formula.text;
    expression.function = MakeExpression(formula.text, { { &field, 1 } });
    expression.values = field.values;
    bounds = std::make_unique<EdgeBounds>(mesh, locator.Index().BoundsOf(0), 0, expression, 0);
  }

  [[nodiscard]] Quad BoundedTruthAt(const QuadVec3& xi) const
  {
    const Quad truth = TruthAt(xi);
    return formula.bounded ? formula.bounded(truth) : truth;
  }

  [[nodiscard]] Quad TruthAt(const QuadVec3& xi) const
  {
    Leaves leaves;
    const auto phi = EvaluateQuad(mesh.map, 0, xi);
    const auto u = EvaluateQuad(field.values, 0, xi);
    const QuadInverse inverse(phi);
    leaves.u = u[0].value;
    for (std::size_t c = 0; c < 3; ++c)
    {
      leaves.x[c] = Quad(mesh.centre[c]) + Quad(mesh.size[0]) * phi[c].value;
      for (std::size_t j = 0; j < 3; ++j)
      {
        leaves.slope[c] = leaves.slope[c] + u[0].gradient[j] * inverse.Cofactor[c][j];
      }
      leaves.slope[c] = leaves.slope[c] / inverse.Determinant / Quad(mesh.size[0]);
    }
    return formula.truth(leaves);
  }

  /// The point as the tracer locates it, with the value that bounds are of.
  [[nodiscard]] std::optional<LocatedPoint> Located(const Vec3& x) const
  {
    auto point = EdgeCase::Located(x);
    if (point)
    {
      EvaluateAt(
        mesh, expression, 0, { &point->xi, 1 }, { &point->value, 1 }, {}, { .x = { &x, 1 } });
      point->value = expression.function->JetValue(0, point->value);
    }
    return point;
  }

  Formula formula;
  Field expression;
};

template <class Check>
void ForAllCases(Random& random, const Check& check)
{
  for (const Shape shape : kShapes)
  {
    for (int order = 1; order <= 3; ++order)
    {
      for (const Formula& formula : Formulas())
      {
        SCOPED_TRACE(
          ::testing::Message() << Name(shape) << ", order " << order << ", " << formula.text);
        check(ExpressionCase(shape, order, order + 1, formula, random));
      }
    }
  }
}

Vec3 NearbyEta(const Vec3& eta, Random& random)
{
  return glm::clamp(
    eta + std::pow(10.0, random(-5.0, -1.0)) * Direction(random), Vec3(-1.0), Vec3(1.0));
}
} // namespace

TEST(ExpressionEdges, RangesHoldValues)
{
  Random random(71);
  int bounded = 0;
  int all = 0;
  ForAllCases(random,
    [&](const ExpressionCase& one)
    {
      const CertifiedRange range =
        RangeOf(one.mesh, 0, { .field = &one.expression }, { 1e-2, 300 });
      ++all;
      bounded += range.outer.IsFinite() ? 1 : 0;
      for (int k = 0; k < 40; ++k)
      {
        const auto truth =
          static_cast<double>(one.TruthAt(ToQuad(random.Inside(one.mesh.ShapeOf(0)))));
        EXPECT_GE(truth, range.outer.lower);
        EXPECT_LE(truth, range.outer.upper);
      }
      EXPECT_GE(range.attained.lower, range.outer.lower);
      EXPECT_LE(range.attained.upper, range.outer.upper);
    });
  std::cout << bounded << " of " << all << " ranges are bounded\n";
  EXPECT_GT(bounded, 0.95 * all);
}

/// Fields of zeros have no scale; expressions of them have bounds all the same.
TEST(ExpressionEdges, FieldsOfZerosAreKnown)
{
  Random random(70);
  for (const std::string text : { "2*u + x", "grad(u).x + x", "u*u + x" })
  {
    ExpressionCase one(Shape::Hexahedron, 2, 3, { text, {} }, random);
    one.SetField(
      UniformSpace(Shape::Hexahedron, 2), std::vector<double>(27, 0.0), 1, Mapping::Identity);
    const CertifiedRange range = RangeOf(one.mesh, 0, { .field = &one.expression }, { 1e-3, 1000 });
    const Box3 box = one.locator.Index().ElementBox(0);
    EXPECT_GE(range.outer.lower, box.lower.x - 1e-9);
    EXPECT_LE(range.outer.upper, box.upper.x + 1e-9);
  }
}

TEST(ExpressionEdges, AlongHoldsDensePoints)
{
  constexpr int kPoints = 32;
  Random random(72);
  int answered = 0;
  int asked = 0;
  ForAllCases(random,
    [&](const ExpressionCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 6; ++k)
      {
        const Vec3 eta(random(), random(), random());
        const auto a = one.Located(one.PointAt(TensorToReference(shape, eta)));
        const auto b = one.Located(one.PointAt(TensorToReference(shape, NearbyEta(eta, random))));
        if (!a || !b)
        {
          continue;
        }
        const double between = 0.5 * (a->value + b->value);
        const ValueSet wanted{ { &between, 1 } };
        asked += one.formula.isSmooth && shape != Shape::Pyramid ? 1 : 0;
        const auto range = one.bounds->Along(*a, *b, 0.0, nullptr, k % 2 == 0 ? &wanted : nullptr);
        if (!range)
        {
          continue;
        }
        answered += one.formula.isSmooth && shape != Shape::Pyramid ? 1 : 0;
        const Segment segment{ a->x, b->x };
        std::optional<QuadVec3> at = ToQuad(a->xi);
        double worst = 0.0;
        for (int i = 0; i <= kPoints; ++i)
        {
          const Quad s = Quad(i) / Quad(kPoints);
          at = Preimage(one.mesh, 0, testing::PointAt(segment, s), *at);
          ASSERT_TRUE(at);
          const Quad truth = one.BoundedTruthAt(*at);
          const Quad line = Quad(a->value) + s * (Quad(b->value) - Quad(a->value));
          worst = std::max(worst, static_cast<double>(Abs(truth - line)));
          if (i == 0 || i == kPoints)
          {
            EXPECT_LE(
              static_cast<double>(Abs(truth - Quad(i == 0 ? a->value : b->value))), range->error);
          }
        }
        EXPECT_LE(worst, range->deviation);
      }
    });
  std::cout << answered << " of " << asked << " edges of smooth expressions\n";
  EXPECT_GT(answered, 0.9 * asked);
}

TEST(ExpressionEdges, PartsOfPlanesHoldTheirValues)
{
  Random random(73);
  int kept = 0;
  int planar = 0;
  ForAllCases(random,
    [&](const ExpressionCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 4; ++k)
      {
        const Vec3 eta(random(), random(), random());
        std::array<LocatedPoint, 3> triangle;
        std::array<Vec3, 3> corners;
        const double size = 0.25 * std::pow(10.0, random(-4.0, -1.0));
        bool isInside = true;
        for (std::size_t i = 0; i < 3; ++i)
        {
          corners[i] = i == 0 ? one.PointAt(TensorToReference(shape, eta))
                              : corners[0] + size * Direction(random);
          const auto point = one.Located(corners[i]);
          isInside = isInside && point;
          triangle[i] = point.value_or(LocatedPoint{});
        }
        const WideOutline part{ Outline{ std::span<const Vec3>(corners) }, 1e-15 };
        const double middle = triangle[0].value;
        const ValueSet wanted{ { &middle, 1 } };
        const auto over = isInside ? one.bounds->Over(triangle, part, wanted) : std::nullopt;
        planar += over ? 1 : 0;
        for (int i = 0; i < 20; ++i)
        {
          const double s = random(0.0, 1.0);
          const double t = random(0.0, 1.0) * (1.0 - s);
          const auto point =
            one.Located(corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]));
          const auto at =
            point ? Preimage(one.mesh, 0, ToQuad(point->x), ToQuad(point->xi)) : std::nullopt;
          if (!at)
          {
            continue;
          }
          ++kept;
          const auto truth = static_cast<double>(one.BoundedTruthAt(*at));
          EXPECT_TRUE(one.bounds->MayTake({ std::span(&truth, 1) }, part,
            { EdgeEffort::kAny, k % 2 == 0 ? EdgeEffort::kAny : 0 }));
          if (over)
          {
            EXPECT_GE(truth, over->values.lower);
            EXPECT_LE(truth, over->values.upper);
            EXPECT_LE(std::fabs(truth - over->At(point->x)), over->error);
          }
        }
      }
    });
  std::cout << kept << " points, " << planar << " parts of planes\n";
  EXPECT_GT(kept, 3000);
  EXPECT_GT(planar, 100);
}
} // namespace pixelexact::testing
