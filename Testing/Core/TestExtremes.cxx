// SPDX-License-Identifier: BSD-3-Clause
// Extremes with their places, against values in 113 bits on dense grids and at the places.
#include "RangeCases.h"

#include "Core/Location/Extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
constexpr int kGridPoints = 9;

/// Visits the points of a grid in the cube of eta, off the apex of a pyramid.
template <class Visit>
void ForEachGridPoint(Shape shape, const Visit& visit)
{
  for (int i = 0; i < kGridPoints * kGridPoints * kGridPoints; ++i)
  {
    const auto at = [](int k) { return 2.0 * k / (kGridPoints - 1) - 1.0; };
    Vec3 eta(
      at(i / (kGridPoints * kGridPoints)), at(i / kGridPoints % kGridPoints), at(i % kGridPoints));
    if (shape == Shape::Pyramid && eta.z == 1.0)
    {
      eta.z = 1.0 - 0x1p-30;
    }
    visit(eta);
  }
}

double ExactAt(const RangeCase& one, const RangeQuestion& question, const Vec3& eta)
{
  const auto exact = static_cast<double>(QuantityQuad(one, question, eta));
  return question.quantity == Quantity::Magnitude ? std::sqrt(exact) : exact;
}

void Check(const RangeCase& one, const RangeQuestion& question)
{
  const Extremes found = FindExtremes(one.mesh, question, false);
  const Shape shape = one.mesh.ShapeOf(0);
  double lowest = INFINITY;
  double highest = -INFINITY;
  ForEachGridPoint(shape,
    [&](const Vec3& eta)
    {
      const Quad exact = QuantityQuad(one, question, eta);
      EXPECT_TRUE(Holds({ found.minimum.bound, found.maximum.bound }, question, exact));
      lowest = std::min(lowest, ExactAt(one, question, eta));
      highest = std::max(highest, ExactAt(one, question, eta));
    });
  const double range = found.maximum.value - found.minimum.value;
  const double rounding = 1e-13 * std::max(std::fabs(lowest), std::fabs(highest));
  EXPECT_TRUE(found.met) << Name(shape);
  EXPECT_LE(found.minimum.value, lowest + 1e-9 * range + rounding);
  EXPECT_GE(found.maximum.value, highest - 1e-9 * range - rounding);
  for (const Extreme* const end : { &found.minimum, &found.maximum })
  {
    EXPECT_EQ(end->element, 0);
    EXPECT_GE(Margin(shape, end->xi), -1e-15);
    if (shape != Shape::Pyramid || end->xi.z < 1.0)
    {
      const double exact = ExactAt(one, question, ReferenceToTensor(shape, end->xi));
      EXPECT_NEAR(end->value, exact, 10 * rounding);
    }
    EXPECT_NEAR(end->value, end->attained, 10 * rounding);
    EXPECT_GE(end->gap, 0.0);
    EXPECT_LE(end->gap, 1e-9 * range + 10 * rounding);
  }
  EXPECT_LE(found.minimum.bound, found.minimum.value);
  EXPECT_GE(found.maximum.bound, found.maximum.value);
}
} // namespace

TEST(Extremes, HoldDenseSamplesAndAreAttained)
{
  Random random(7);
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 3, 6 })
    {
      for (int repeat = 0; repeat < 3; ++repeat)
      {
        RangeCase one(UniformSpace(shape, 1), [](const LongVec3& xi) { return xi; });
        one.SetNoise(order, random, 0.5);
        Check(one, { Quantity::Component, &one.field });
      }
    }
  }
}

TEST(Extremes, OfAMagnitudeThatVanishesInside)
{
  for (const Shape shape : kShapes)
  {
    // v = xi - c with c inside of all shapes.
    RangeCase one(UniformSpace(shape, 1), [](const LongVec3& xi) { return xi; });
    const Space space = UniformSpace(shape, 1);
    ExpansionBuilder v(3);
    v.Add(space,
      [](const LongVec3& xi, long double* out)
      {
        out[0] = xi[0] + 0.5L;
        out[1] = xi[1] + 0.625L;
        out[2] = xi[2] + 0.375L;
      });
    const Expansion view = v.View();
    one.SetField(space, { view.coefficients.begin(), view.coefficients.end() }, 3);
    const Extremes found = FindExtremes(one.mesh, { Quantity::Magnitude, &one.field }, false);
    EXPECT_LE(found.minimum.value, 1e-7) << Name(shape);
    EXPECT_NEAR(found.minimum.xi.x, -0.5, 1e-7);
    EXPECT_NEAR(found.minimum.xi.y, -0.625, 1e-7);
    EXPECT_NEAR(found.minimum.xi.z, -0.375, 1e-7);
    EXPECT_GE(found.minimum.bound, 0.0);
  }
}

TEST(Extremes, OfAFieldThatIsNotFiniteAreNotKnown)
{
  RangeCase one(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  const Space space = UniformSpace(Shape::Hexahedron, 1);
  std::vector<double> modes(static_cast<std::size_t>(space.Modes()), 1.0);
  modes[3] = NAN;
  one.SetField(space, modes);
  const Extremes found = FindExtremes(one.mesh, { Quantity::Component, &one.field }, false);
  EXPECT_EQ(found.notFinite, 1);
  EXPECT_EQ(found.minimum.element, -1);
  EXPECT_TRUE(std::isnan(found.maximum.value));
}
} // namespace pixelexact::testing
