// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeCases.h"

#include "Core/Questions/QuotientModes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

// H(curl), H(div) and density fields of noise on curved elements, in 113 bits: their bounds along
// edges, and bounds of their quotients.
namespace pixelexact::testing
{
namespace
{
constexpr Mapping kMappings[] = { Mapping::Covariant, Mapping::Contravariant, Mapping::Density };

struct MappedCase : EdgeCase
{
  MappedCase(Shape shape, int mapOrder, int fieldOrder, Mapping mapping, int which, Random& random)
    : EdgeCase(shape, mapOrder, fieldOrder, random)
    , component(which)
  {
    const Space noise = UniformSpace(shape, fieldOrder);
    const int components = mapping == Mapping::Density ? 1 : 3;
    std::vector<double> modes;
    for (int c = 0; c < components; ++c)
    {
      ForEachMode(noise,
        [&](int p, int q, int r, int) { modes.push_back(random() * std::pow(0.6, p + q + r)); });
    }
    SetField(noise, modes, components, mapping);
    bounds = std::make_unique<EdgeBounds>(mesh, locator.Index().BoundsOf(0), 0, field, component);
    for (int i = 0; i < 50; ++i)
    {
      const Quad value = TruthAt(ToQuad(random.Inside(shape)));
      largest = std::max(largest, static_cast<double>(Abs(value)));
    }
  }

  [[nodiscard]] Quad TruthAt(const QuadVec3& xi) const
  {
    const auto u = WorldValuesQuad(mesh, field, 0, xi);
    if (component >= 0)
    {
      return u[static_cast<std::size_t>(component)];
    }
    Quad square;
    for (const Quad& c : u)
    {
      square = square + c * c;
    }
    // One Newton step from the nearest double.
    const Quad root(std::sqrt(static_cast<double>(square)));
    return (root + square / root) / Quad(2.0);
  }

  /// The point as the tracer locates it.
  [[nodiscard]] std::optional<LocatedPoint> Located(const Vec3& x) const
  {
    std::int32_t element = -1;
    LocatedPoint point{ x };
    std::vector<double> value(static_cast<std::size_t>(field.values.components));
    SampleTarget target;
    target.element = { &element, 1 };
    target.xi = { &point.xi, 1 };
    SampleTile(locator, nullptr, std::span(&x, 1), target);
    if (element < 0)
    {
      return std::nullopt;
    }
    EvaluateAt(mesh, field, 0, { &point.xi, 1 }, value, {});
    point.eta = ReferenceToTensor(mesh.ShapeOf(0), point.xi);
    point.value = component >= 0 ? value[static_cast<std::size_t>(component)]
                                 : std::hypot(value[0], value[1], value[2]);
    return point;
  }

  int component;
  double largest = 0.0; ///< of some values
};

template <class Check>
void ForAllCases(Random& random, const Check& check)
{
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    for (const Mapping mapping : kMappings)
    {
      for (int order = 1; order <= 3; ++order)
      {
        const int which = mapping == Mapping::Density ? 0 : order - 2;
        SCOPED_TRACE(::testing::Message()
          << Name(shape) << ", mapping " << static_cast<int>(mapping) << ", order " << order
          << ", component " << which);
        check(MappedCase(shape, order, order + 1, mapping, which, random));
      }
    }
  }
}
} // namespace

TEST(MappedEdges, AlongHoldsDensePoints)
{
  constexpr int kPoints = 32;
  Random random(91);
  int answered = 0;
  int asked = 0;
  double least = 1.0;
  ForAllCases(random,
    [&](const MappedCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 12; ++k)
      {
        const Vec3 eta(random(), random(), random());
        const Vec3 other = glm::clamp(
          eta + std::pow(10.0, random(-5.0, -1.0)) * Direction(random), Vec3(-1.0), Vec3(1.0));
        const auto a = one.Located(one.PointAt(TensorToReference(shape, eta)));
        const auto b = one.Located(one.PointAt(TensorToReference(shape, other)));
        if (!a || !b)
        {
          continue;
        }
        ++asked;
        const auto range = one.bounds->Along(*a, *b);
        if (!range)
        {
          continue;
        }
        ++answered;
        const Segment segment{ a->x, b->x };
        std::optional<QuadVec3> at = ToQuad(a->xi);
        Quad size;
        double worst = 0.0;
        for (int i = 0; i <= kPoints; ++i)
        {
          const Quad s = Quad(i) / Quad(kPoints);
          at = Preimage(one.mesh, 0, testing::PointAt(segment, s), *at);
          ASSERT_TRUE(at);
          const Quad truth = one.TruthAt(*at);
          const Quad line = Quad(a->value) + s * (Quad(b->value) - Quad(a->value));
          worst = std::max(worst, static_cast<double>(Abs(truth - line)));
          size = std::max(size, Abs(truth));
          if (i == 0 || i == kPoints)
          {
            EXPECT_LE(
              static_cast<double>(Abs(truth - Quad(i == 0 ? a->value : b->value))), range->error);
          }
        }
        EXPECT_LE(worst, range->deviation);
        EXPECT_LE(range->error, 1e-6 * one.largest);
        least = std::min(least, range->deviation / static_cast<double>(size));
      }
    });
  std::cout << answered << " of " << asked << " edges; least deviation over size " << least << '\n';
  EXPECT_GT(answered, 0.9 * asked);
}

/// Errors of sums in single precision.
TEST(MappedEdges, ErrorsHoldValuesInFloats)
{
  Random random(95);
  int answered = 0;
  ForAllCases(random,
    [&](const MappedCase& one)
    {
      const EdgeBounds inFloats(one.mesh, one.locator.Index().BoundsOf(0), 0, one.field,
        std::max(one.component, 0), 0x1p-19);
      for (int k = 0; k < 12; ++k)
      {
        const Vec3 eta(random(), random(), random());
        auto point = one.Located(one.PointAt(TensorToReference(one.mesh.ShapeOf(0), eta)));
        if (!point)
        {
          continue;
        }
        std::int32_t element = -1;
        std::vector<double> value(static_cast<std::size_t>(one.field.values.components));
        SampleTarget target;
        target.element = { &element, 1 };
        target.value = value;
        target.precision = Precision::Float;
        SampleTile(one.locator, &one.field, std::span(&point->x, 1), target);
        point->value = value[static_cast<std::size_t>(std::max(one.component, 0))];
        const auto range = inFloats.Along(*point, *point);
        const auto at = Preimage(one.mesh, 0, ToQuad(point->x), ToQuad(point->xi));
        if (!range || !at)
        {
          continue;
        }
        ++answered;
        const auto truth = WorldValuesQuad(one.mesh, one.field, 0, *at);
        const Quad off =
          truth[static_cast<std::size_t>(std::max(one.component, 0))] - Quad(point->value);
        EXPECT_LE(static_cast<double>(Abs(off)), range->error);
      }
    });
  EXPECT_GT(answered, 250);
}

TEST(MappedEdges, MayTakeWhatPartsOfPlanesTake)
{
  Random random(92);
  int kept = 0;
  ForAllCases(random,
    [&](const MappedCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 8; ++k)
      {
        std::array<Vec3, 3> corners;
        corners[0] = one.PointAt(TensorToReference(shape, { random(), random(), random() }));
        const double size = 0.25 * std::pow(10.0, random(-4.0, -1.0));
        corners[1] = corners[0] + size * Direction(random);
        corners[2] = corners[0] + size * Direction(random);
        const Outline outline{ std::span<const Vec3>(corners) };
        for (int i = 0; i < 20; ++i)
        {
          const double s = random(0.0, 1.0);
          const double t = random(0.0, 1.0) * (1.0 - s);
          const auto point =
            one.Located(corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]));
          if (!point)
          {
            continue;
          }
          ++kept;
          const double value = point->value;
          EXPECT_TRUE(one.bounds->MayTake(
            { std::span(&value, 1) }, { outline, 1e-15 }, { EdgeEffort::kAny, EdgeEffort::kAny }));
        }
        const double beyond = 1e3 * one.bounds->Values().Magnitude();
        EXPECT_EQ(one.bounds->MayTake({ std::span(&beyond, 1) }, { outline, 1e-15 }, {}),
          !std::isfinite(beyond));
      }
    });
  EXPECT_GT(kept, 2000);
}

/// N / D is the field, to what slack and rounding allow.
TEST(MappedEdges, QuotientsAreTheField)
{
  Random random(93);
  ForAllCases(random,
    [&](const MappedCase& one)
    {
      const auto quotient = MakeQuotientModes(one.mesh, 0, one.field, -1);
      ASSERT_TRUE(quotient);
      const auto& space = quotient->divisor.space;
      const auto valueOf = [&](const ScaledModes& modes, std::size_t c, const QuadVec3& xi)
      {
        const std::vector<Space> spaces{ space };
        const std::vector<std::int32_t> spaceOf{ 0 };
        const std::vector<std::int64_t> offset{ 0 };
        const std::vector<double> own(
          modes.values.begin() + static_cast<std::ptrdiff_t>(c * modes.width),
          modes.values.begin() + static_cast<std::ptrdiff_t>((c + 1) * modes.width));
        const Expansion expansion{ spaces, spaceOf, offset, own, 1 };
        return EvaluateQuad(expansion, 0, xi)[0].value * Quad(std::ldexp(1.0, modes.exponent));
      };
      for (int k = 0; k < 10; ++k)
      {
        const QuadVec3 xi = ToQuad(random.Inside(one.mesh.ShapeOf(0)));
        const auto truth = WorldValuesQuad(one.mesh, one.field, 0, xi);
        const Quad divisor = valueOf(quotient->divisor, 0, xi);
        for (std::size_t c = 0; c < truth.size(); ++c)
        {
          const Quad off = valueOf(quotient->numerators, c, xi) / divisor - truth[c];
          EXPECT_LE(
            static_cast<double>(Abs(off)), 1e-11 * (1.0 + static_cast<double>(Abs(truth[c]))));
          // The bound from the slacks of numerator and divisor.
          const Quad slack =
            (Quad(quotient->numeratorSlack) + Abs(truth[c]) * Quad(quotient->divisorSlack)) /
            Abs(divisor);
          EXPECT_LE(static_cast<double>(Abs(off)), 1.01 * static_cast<double>(slack));
        }
      }
    });
}

TEST(MappedEdges, NothingIsKnownInPyramids)
{
  Random random(94);
  const MappedCase one(Shape::Pyramid, 2, 2, Mapping::Contravariant, 0, random);
  EXPECT_TRUE(one.bounds->HasValues());
  EXPECT_FALSE(one.bounds->Values().IsFinite());
  const auto a = one.Located(one.PointAt({ 0.0, 0.0, -0.5 }));
  const auto b = one.Located(one.PointAt({ 0.01, 0.0, -0.5 }));
  ASSERT_TRUE(a && b);
  EXPECT_FALSE(one.bounds->Along(*a, *b));
  const double value = 1e30;
  EXPECT_TRUE(one.bounds->MayTake({ std::span(&value, 1) }, { Outline(a->x, b->x), 0.0 }, {}));
}
} // namespace pixelexact::testing
