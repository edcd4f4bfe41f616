// SPDX-License-Identifier: BSD-3-Clause
// Bounds along edges against dense points of them, inverted and evaluated in 113 bits.
#include "EdgeCases.h"

#include <algorithm>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
constexpr EdgeEffort kAnyEffort{ EdgeEffort::kAny, EdgeEffort::kAny };

double SlackOf(const Vec3& x)
{
  return 16.0 * 0x1p-53 * std::max({ std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
}
} // namespace

/// Edges from a hundred-thousandth of the element to a third of it, some between points of faces.
TEST(EdgeBounds, AlongHoldsDensePoints)
{
  constexpr int kPoints = 64;
  Random random(71);
  int answered = 0;
  int shortOnes = 0;
  int shortAnswered = 0;
  double least = 1.0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 6; ++k)
      {
        Vec3 eta(random(), random(), random());
        Vec3 other = eta + std::pow(10.0, random(-5.0, -0.5)) * Direction(random);
        other = glm::clamp(other, Vec3(-1.0), Vec3(1.0));
        if (k == 0)
        {
          eta[1] = other[1] = -1.0;
        }
        const auto a = one.Located(one.PointAt(TensorToReference(shape, eta)));
        const auto b = one.Located(one.PointAt(TensorToReference(shape, other)));
        if (!a || !b)
        {
          continue;
        }
        const auto range = one.bounds->Along(*a, *b);
        const bool isShort = glm::distance(a->xi, b->xi) < 1e-2 && k > 0;
        shortOnes += isShort ? 1 : 0;
        shortAnswered += isShort && range ? 1 : 0;
        if (!range)
        {
          continue;
        }
        ++answered;
        const Segment segment{ a->x, b->x };
        std::optional<QuadVec3> at = ToQuad(a->xi);
        double worst = 0.0;
        for (int i = 0; i <= kPoints; ++i)
        {
          const Quad s = Quad(i) / Quad(kPoints);
          at = Preimage(one.mesh, 0, PointAt(segment, s), *at);
          ASSERT_TRUE(at);
          EXPECT_GE(DepthIn(shape, *at), -1e-9);
          const Quad truth = one.Truth(*at);
          const Quad line = Quad(a->value) + s * (Quad(b->value) - Quad(a->value));
          worst = std::max(worst, static_cast<double>(Abs(truth - line)));
          if (i == 0 || i == kPoints)
          {
            EXPECT_LE(
              static_cast<double>(Abs(truth - Quad(i == 0 ? a->value : b->value))), range->error);
          }
        }
        EXPECT_LE(worst, range->deviation);
        EXPECT_LE(range->error, 1e-11 * one.bounds->Values().Magnitude());
        least = std::min(least, range->deviation / one.range);
      }
    });
  std::cout << answered << " edges, of " << shortOnes << " short ones " << shortAnswered
            << "; least deviation over range " << least << '\n';
  EXPECT_GT(answered, 350);
  EXPECT_GT(shortAnswered, 0.9 * shortOnes);
}

/// At a quarter of the length, the deviation is a sixteenth, up to rounding.
TEST(EdgeBounds, DeviationFallsWithTheSquareOfTheLength)
{
  Random random(72);
  int compared = 0;
  std::vector<double> overTrue;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      for (int k = 0; k < 4; ++k)
      {
        const auto a = one.Located(one.PointAt(random.Inside(one.mesh.ShapeOf(0))));
        const Vec3 step = 0.02 * kEdgeCaseSize * Direction(random);
        if (!a)
        {
          continue;
        }
        // Infinite where nothing is proven.
        const auto deviationTo = [&](const Vec3& x)
        {
          const auto end = one.Located(x);
          const auto range = end ? one.bounds->Along(*a, *end) : std::nullopt;
          return range ? range->deviation : std::numeric_limits<double>::infinity();
        };
        const double far = deviationTo(a->x + step);
        const double near = deviationTo(a->x + 0.25 * step);
        if (!std::isfinite(far) || !std::isfinite(near))
        {
          continue;
        }
        ++compared;
        EXPECT_LE(near, far / 12.0 + 1e-8 * one.bounds->Values().Magnitude());
        const auto middle = one.Located(a->x + 0.5 * step);
        const auto end = one.Located(a->x + step);
        ASSERT_TRUE(middle && end);
        const double off = std::fabs(middle->value - 0.5 * (a->value + end->value));
        overTrue.push_back(far / (off + 1e-12 * one.range));
      }
    });
  ASSERT_GT(compared, 300);
  std::ranges::nth_element(overTrue, overTrue.begin() + std::ssize(overTrue) / 2);
  std::cout << compared << " edges, median of the bound over the middle's deviation "
            << overTrue[overTrue.size() / 2] << '\n';
  EXPECT_LT(overTrue[overTrue.size() / 2], 100.0);
}

/// Curves that deviate from the straight edge by a sagitta.
TEST(EdgeBounds, AlongHoldsCurvesBesideTheEdge)
{
  Random random(73);
  int answered = 0;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 3, 4 })
    {
      const EdgeCase one(shape, order, order + 2, random);
      for (int k = 0; k < 12; ++k)
      {
        const auto a = one.Located(one.PointAt(random.Inside(shape)));
        const Vec3 chord = 0.01 * kEdgeCaseSize * Direction(random);
        const auto b = a ? one.Located(a->x + chord) : std::nullopt;
        const double sagitta = 1e-4 * kEdgeCaseSize;
        const auto range = b ? one.bounds->Along(*a, *b, sagitta) : std::nullopt;
        if (!range)
        {
          continue;
        }
        ++answered;
        const Vec3 aside = 0.999 * sagitta * Direction(random);
        for (int i = 0; i <= 32; ++i)
        {
          const double s = i / 32.0;
          const Vec3 x = a->x + s * chord + 4.0 * s * (1.0 - s) * aside;
          const auto at = Preimage(one.mesh, 0, ToQuad(x), ToQuad(a->xi));
          ASSERT_TRUE(at);
          EXPECT_GE(DepthIn(shape, *at), -1e-9);
          const Quad line = Quad(a->value) + Quad(s) * (Quad(b->value) - Quad(a->value));
          EXPECT_LE(static_cast<double>(Abs(one.Truth(*at) - line)), range->deviation);
        }
      }
    }
  }
  EXPECT_GT(answered, 80);
}

/// Segments in the element, through its faces, and from outside to a face, with the values that
/// they take, also at their ends.
TEST(EdgeBounds, MayTakeWhatTheSegmentTakes)
{
  Random random(74);
  int taken = 0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 6; ++k)
      {
        Vec3 eta(random(), random(), random());
        if (k % 3 == 0)
        {
          // The face is not collapsed.
          eta[1] = -1.0;
        }
        const Vec3 x = one.PointAt(TensorToReference(shape, eta));
        const double length = kEdgeCaseSize * std::pow(10.0, random(-6.0, 0.5));
        const Vec3 along = length * Direction(random);
        const double part = k % 2 == 0 ? 0.0 : random(0.0, 1.0);
        const Segment segment{ x - part * along, x + (1.0 - part) * along };
        const auto known = one.Located(x);
        if (!known)
        {
          continue;
        }
        const auto values = ValuesAlong(one, segment, part, known->xi, 16);
        for (const Quad& value : values)
        {
          const double taking = static_cast<double>(value);
          for (const EdgeEffort& effort : { EdgeEffort{}, EdgeEffort{ 0, 6 }, kAnyEffort })
          {
            EXPECT_TRUE(one.bounds->MayTake(ValueSet{ { &taking, 1 } },
              { { segment.from, segment.to }, SlackOf(kEdgeCaseCentre) }, effort))
              << "of length " << length << ", case " << k;
          }
          ++taken;
        }
      }
    });
  std::cout << taken << " values\n";
  EXPECT_GT(taken, 5000);
}

/// Elements where a rounding error of the map causes an error of 1e5 or 1e8 roundings in xi.
TEST(EdgeBounds, MayTakeWhatSegmentsOfFlatElementsTake)
{
  Random random(76);
  int taken = 0;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3 })
    {
      for (const double flat : { 1e-5, 1e-8 })
      {
        SCOPED_TRACE(
          ::testing::Message() << Name(shape) << ", map of order " << order << ", flat " << flat);
        const EdgeCase one(shape, order, order + 1, random, flat);
        for (int k = 0; k < 20; ++k)
        {
          const Vec3 xi = random.Inside(shape);
          const Vec3 from = one.PointAt(xi);
          const Vec3 to = one.PointAt(xi + std::pow(10.0, random(-4.0, -1.0)) * Direction(random));
          const auto known = one.Located(from);
          if (!known)
          {
            continue;
          }
          for (const Quad& value : ValuesAlong(one, { from, to }, 0.0, known->xi, 8))
          {
            const double taking = static_cast<double>(value);
            EXPECT_TRUE(one.bounds->MayTake(
              ValueSet{ { &taking, 1 } }, { { from, to }, SlackOf(kEdgeCaseCentre) }, kAnyEffort));
            ++taken;
          }
        }
      }
    }
  }
  std::cout << taken << " values\n";
  EXPECT_GT(taken, 1000);
}

/// Short segments whose values differ from the wanted one by a hundredth of the range.
TEST(EdgeBounds, MayTakeIsTight)
{
  Random random(75);
  int asked = 0;
  int proven = 0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      for (int k = 0; k < 6; ++k)
      {
        const auto known = one.Located(one.PointAt(random.Inside(one.mesh.ShapeOf(0))));
        if (!known)
        {
          continue;
        }
        const Vec3 along = 1e-3 * kEdgeCaseSize * Direction(random);
        const Segment segment{ known->x - 0.5 * along, known->x + 0.5 * along };
        const auto values = ValuesAlong(one, segment, 0.5, known->xi, 4);
        if (values.empty())
        {
          continue;
        }
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const double besides = 1e-2 * one.range;
        const double missed =
          k % 2 == 0 ? static_cast<double>(*least) - besides : static_cast<double>(*most) + besides;
        ++asked;
        proven += one.bounds->MayTake(ValueSet{ { &missed, 1 } },
                    { { segment.from, segment.to }, SlackOf(kEdgeCaseCentre) }, kAnyEffort)
          ? 0
          : 1;
      }
    });
  std::cout << proven << " of " << asked << " are proven\n";
  EXPECT_GT(asked, 600);
  EXPECT_GT(proven, 0.95 * asked);
}

/// Outside of the element no value is taken.
TEST(EdgeBounds, NothingIsTakenFarOutside)
{
  Random random(76);
  for (const Shape shape : kShapes)
  {
    const EdgeCase one(shape, 3, 5, random);
    const double value = one.ValueAt(Centre(shape));
    const Vec3 far = kEdgeCaseCentre + Vec3(4.0 * kEdgeCaseSize, 0.0, 0.0);
    EXPECT_FALSE(one.bounds->MayTake(
      ValueSet{ { &value, 1 } }, { { far, far + Vec3(0.1) }, 1e-12 }, kAnyEffort));
  }
}

TEST(EdgeBounds, ChangeWithinHoldsNearPoints)
{
  Random random(77);
  int known = 0;
  int all = 0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 6; ++k)
      {
        const auto point = one.Located(one.PointAt(random.Inside(shape)));
        const Vec3 step = std::pow(10.0, random(-6.0, -3.0)) * Direction(random);
        if (!point || DepthIn(shape, ToQuad(point->xi + step)) < 0.0)
        {
          continue;
        }
        const auto from = one.Truth(ToQuad(point->xi));
        const auto to = one.Truth(ToQuad(point->xi + step));
        const double distance = glm::distance(point->x, one.PointAt(point->xi + step));
        const double change = one.bounds->ChangeWithin(*point, distance + 1e-15);
        EXPECT_LE(static_cast<double>(Abs(to - from)), change);
        ++all;
        known += std::isfinite(change) ? 1 : 0;
      }
    });
  EXPECT_GT(all, 500);
  EXPECT_GT(known, 0.95 * all);
}

TEST(EdgeBounds, OfWhatIsNotFiniteNothingIsKnown)
{
  Random random(78);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EdgeCase one(Shape::Prism, 2, 3, random);
    one.values[1] = bad;
    one.Renew();
    const auto a = one.Located(one.PointAt(Vec3(-0.5, 0.0, -0.5)));
    const auto b = one.Located(one.PointAt(Vec3(-0.501, 0.0, -0.5)));
    ASSERT_TRUE(a && b);
    EXPECT_FALSE(one.bounds->Values().IsFinite());
    EXPECT_FALSE(one.bounds->Along(*a, *b));
    const double value = 0.0;
    EXPECT_TRUE(
      one.bounds->MayTake(ValueSet{ { &value, 1 } }, { { a->x, b->x }, 1e-15 }, kAnyEffort));
    EXPECT_FALSE(std::isfinite(one.bounds->ChangeWithin(*a, 1e-9)));
  }
}

TEST(EdgeBounds, ConstantFieldsDeviateByRounding)
{
  Random random(79);
  for (const Shape shape : kShapes)
  {
    EdgeCase one(shape, 3, 4, random);
    std::ranges::fill(one.values, 0.0);
    one.values[0] = 2.5;
    one.Renew();
    const auto a = one.Located(one.PointAt(Centre(shape)));
    const auto b = one.Located(one.PointAt(Centre(shape) + Vec3(1e-2, 0.0, 0.0)));
    ASSERT_TRUE(a && b);
    const auto range = one.bounds->Along(*a, *b);
    ASSERT_TRUE(range);
    EXPECT_LE(range->deviation, 1e-12) << Name(shape);
    EXPECT_LE(range->error, 1e-12);
    const double value = a->value;
    EXPECT_TRUE(
      one.bounds->MayTake(ValueSet{ { &value, 1 } }, { { a->x, b->x }, 1e-15 }, kAnyEffort));
    const double missed = value + 1e-9;
    EXPECT_FALSE(
      one.bounds->MayTake(ValueSet{ { &missed, 1 } }, { { a->x, b->x }, 1e-15 }, kAnyEffort));
  }
}
} // namespace pixelexact::testing
