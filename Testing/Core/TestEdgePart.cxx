// SPDX-License-Identifier: BSD-3-Clause
// Parts of planes through three points of an element, against points of them inverted and evaluated
// in 113 bits.
#include "ContourCheck.h"
#include "EdgeCases.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/Plateau.h"

#include <array>
#include <iostream>

namespace pixelexact::testing
{
/// Squares about the triangle, as a block of pixels surrounds three of its centres, from a
/// millionth of the element to a third of it. The values of the affine function are included where
/// requested.
TEST(EdgePart, HoldsTheValuesOfItsPoints)
{
  Random random(91);
  int answered = 0;
  int shortOnes = 0;
  int shortAnswered = 0;
  int affine = 0;
  double least = 1.0;
  ForAllOrders(random,
    [&](const EdgeCase& one)
    {
      const Shape shape = one.mesh.ShapeOf(0);
      for (int k = 0; k < 6; ++k)
      {
        const double length = kEdgeCaseSize * std::pow(10.0, random(-6.0, -0.5));
        const Vec3 u = length * Direction(random);
        const Vec3 v = length * Direction(random);
        const auto first = one.Located(one.PointAt(random.Inside(shape)));
        const auto second = first ? one.Located(first->x + u) : std::nullopt;
        const auto third = first ? one.Located(first->x + v) : std::nullopt;
        if (!first || !second || !third)
        {
          continue;
        }
        // The part of one pixel, or of several.
        const double from = -0.5;
        const double to = k % 2 == 0 ? 0.5 : 1.1;
        const auto at = [&](double s, double t) { return first->x + s * u + t * v; };
        const std::array<Vec3, 4> square{ at(from, from), at(to, from), at(to, to), at(from, to) };
        // First the cheap bounds, then with all refinements.
        const ValueSet wanted = k < 2 ? ValueSet{} : ValueSet{ {}, kInfinity, -kInfinity };
        const auto values =
          one.bounds->Over({ *first, *second, *third }, { Outline(square), 1e-14 }, wanted);
        const bool isShort = length < 1e-3 * kEdgeCaseSize;
        shortOnes += isShort ? 1 : 0;
        shortAnswered += isShort && values ? 1 : 0;
        if (!values)
        {
          continue;
        }
        ++answered;
        const Interval& all = values->values;
        least = std::min(least, (all.upper - all.lower) / one.range);
        affine += std::isfinite(values->error) ? 1 : 0;
        std::optional<QuadVec3> xi = ToQuad(first->xi);
        for (int i = 0; i <= 16; ++i)
        {
          for (int j = 0; j <= 16; ++j)
          {
            const double s = from + (to - from) * i / 16.0;
            const double t = from + (to - from) * (i % 2 == 0 ? j : 16 - j) / 16.0;
            xi = Preimage(one.mesh, 0, ToQuad(at(s, t)), *xi);
            ASSERT_TRUE(xi);
            EXPECT_GE(DepthIn(shape, *xi), -1e-9);
            const auto truth = static_cast<double>(one.Truth(*xi));
            EXPECT_LE(all.lower, truth);
            EXPECT_GE(all.upper, truth);
            EXPECT_LE(std::fabs(values->At(at(s, t)) - truth), values->error);
          }
        }
      }
    });
  std::cout << answered << " parts, of " << shortOnes << " short ones " << shortAnswered
            << "; least width over range " << least << '\n';
  EXPECT_GT(answered, 400);
  EXPECT_GT(affine, 200);
  EXPECT_GT(shortAnswered, 0.9 * shortOnes);
}

namespace
{
/// A field of one component in one element of a shape.
struct OneElement
{
  OneElement(Shape shape, int order, const LongScalar& value)
    : values(1)
  {
    values.Add(
      UniformSpace(shape, order), [&](const LongVec3& xi, long double* u) { *u = value(xi); });
  }
  [[nodiscard]] ScaledModes Modes() const
  {
    return { values.Spaces.front(), values.Coefficients.data(), 1 };
  }
  ExpansionBuilder values;
};

} // namespace

/// On a face where a field has a value up to rounding, the bounds contain it. They contain no
/// slightly different value, and none where the field varies slightly.
TEST(EdgePart, FacesHoldTheValuesThatTheyHave)
{
  for (const Shape shape : kShapes)
  {
    for (const int order : { 2, 4, 7 })
    {
      const auto planes = FacePlanesOf(shape);
      for (std::size_t k = 0; k < planes.size(); ++k)
      {
        SCOPED_TRACE(::testing::Message() << Name(shape) << " " << order << " " << k);
        const FacePlane& plane = planes[k];
        for (const double slope : { 0.0, 1e-10 })
        {
          const OneElement wall(shape, order,
            [&](const LongVec3& xi)
            {
              const LongVec3 n = ToLong(plane.gradient);
              const long double distance = Dot(n, xi) + plane.constant;
              return 0.7L + distance * (3 + xi[0] - xi[1]) +
                slope * (xi[0] + 2 * xi[1] + 3 * xi[2]);
            });
          const Interval held = HeldOnFace(wall.Modes(), 1, FacesOf(shape)[k]);
          EXPECT_EQ(held.Contains(0.7), slope == 0.0);
          EXPECT_FALSE(held.Contains(0.7 + 1e-11));
          EXPECT_FALSE(HeldInElement(wall.Modes(), 1).Contains(0.7));
        }
      }
    }
  }
}

/// The result does not depend on how large the field is elsewhere.
TEST(EdgePart, SteepFieldsHoldNothing)
{
  for (const double steepness : { 0x1p20, 0x1p44, 0x1p48 })
  {
    const OneElement steep(
      Shape::Hexahedron, 1, [&](const LongVec3& xi) { return xi[0] + steepness * (xi[2] - 1); });
    for (std::size_t k = 0; k < 6; ++k)
    {
      const Interval held = HeldOnFace(steep.Modes(), 1, FacesOf(Shape::Hexahedron)[k]);
      EXPECT_GT(held.lower, held.upper) << k;
    }
  }
}

/// For a field of zeros only 0 is contained, and for NaN nothing.
TEST(EdgePart, ZerosHoldZero)
{
  const OneElement zero(Shape::Tetrahedron, 3, [](const LongVec3& /*xi*/) { return 0.0L; });
  const Interval held = HeldInElement(zero.Modes(), 1);
  EXPECT_EQ(held.lower, 0.0);
  EXPECT_EQ(held.upper, 0.0);
}
} // namespace pixelexact::testing
