// SPDX-License-Identifier: BSD-3-Clause
// Value enclosures against the same stored polynomials in 113 bits, at points inverted in 113 bits.
#include "EnclosureCases.h"
#include "InstructionSets.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
std::string Describe(const EnclosureCase& c)
{
  return std::string(Name(c.shape)) + " form " + std::to_string(int(c.form)) + " map order " +
    std::to_string(c.mapOrder) + " field order " + std::to_string(c.fieldOrder) + " size " +
    std::to_string(std::ilogb(c.size)) + " offset " + std::to_string(c.offset) + " mapping " +
    std::to_string(int(c.mapping));
}

struct EnclosureTally
{
  int points = 0;
  int everything = 0;
};

/// Checks that every interval contains the true value, and counts unbounded intervals.
EnclosureTally CheckCase(const EnclosureCase& c, int points, double inversionError, Random& random)
{
  SCOPED_TRACE(Describe(c));
  const EnclosureElement element(c, random);
  EnclosureTally tally;
  for (const auto& point : EnclosePoints(element, points, inversionError, random))
  {
    for (std::size_t k = 0; k < point.truth.size(); ++k)
    {
      const Interval& interval = point.interval[k];
      EXPECT_TRUE(Holds(interval, point.truth[k]))
        << "component " << k << " at xi " << point.xi.x << " " << point.xi.y << " " << point.xi.z
        << ": " << double(Quad(interval.lower) - point.truth[k]) << " to "
        << double(Quad(interval.upper) - point.truth[k]) << " around the truth "
        << double(point.truth[k]);
      ++tally.points;
      tally.everything += interval.IsFinite() ? 0 : 1;
    }
  }
  return tally;
}
} // namespace

TEST(Enclosure, HoldsTheTruthForAllShapesAndOrders)
{
  Random random(1);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const int mapOrder : { 1, 2, 3 })
    {
      for (const int fieldOrder : { 0, 1, 2, 3, 4, 6, 8, 12 })
      {
        EnclosureCase c;
        c.shape = shape;
        c.form = form;
        c.mapOrder = mapOrder;
        c.fieldOrder = fieldOrder;
        const EnclosureTally tally = CheckCase(c, 16, 1e-15, random);
        EXPECT_EQ(tally.everything, 0);
      }
    }
  }
}

TEST(Enclosure, IsIndependentOfSizeAndOffset)
{
  Random random(2);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const int exponent : { -498, -100, 0, 100, 498 })
    {
      for (const double offset : { 0.0, 1e4, 1e8 })
      {
        EnclosureCase c;
        c.shape = shape;
        c.form = form;
        c.size = std::ldexp(1.0, exponent);
        c.offset = offset;
        EXPECT_EQ(CheckCase(c, 16, 1e-15, random).everything, 0);
      }
    }
  }
}

TEST(Enclosure, HoldsMappedValues)
{
  Random random(3);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const auto mapping : { Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
    {
      for (const int exponent : { -300, 0, 200 })
      {
        EnclosureCase c;
        c.shape = shape;
        c.form = form;
        c.mapping = mapping;
        c.components = 3;
        c.size = std::ldexp(1.0, exponent);
        EXPECT_EQ(CheckCase(c, 24, 1e-15, random).everything, 0);
      }
    }
  }
}

TEST(Enclosure, HoldsTinyHugeAndManyComponents)
{
  Random random(4);
  for (const double scale : { 5e-324, 1e-315, 1e-300, 1e-280, 1e-260, 1e300 })
  {
    EnclosureCase c;
    c.fieldScale = scale;
    EXPECT_EQ(CheckCase(c, 24, 1e-15, random).everything, 0) << scale;
  }
  EnclosureCase c;
  c.components = 7;
  EXPECT_EQ(CheckCase(c, 9, 1e-15, random).everything, 0);
}

TEST(Enclosure, TakesTheInverseMapsErrorIn)
{
  Random random(5);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    for (const double error : { 1e-14, 1e-12, 1e-10, 1e-8, 1e-6 })
    {
      EnclosureCase c;
      c.shape = shape;
      c.form = form;
      const EnclosureTally tally = CheckCase(c, 24, error, random);
      EXPECT_LE(tally.everything, error > 1e-9 ? 4 : 0) << error;
    }
  }
}

/// A linear field has no curvature whose bound could make up for what a bound of the preimage
/// lacks.
TEST(Enclosure, TakesTheMapsCurvatureIn)
{
  Random random(13);
  for (const double error : { 1e-10, 1e-8, 1e-6, 1e-5 })
  {
    EnclosureElement element({}, random);
    ForEachMode(element.Values.Spaces[0],
      [&](int p, int q, int r, int mode)
      { element.Values.Coefficients[mode] = p + q + r == 1 ? random() : 0.0; });
    int finite = 0;
    for (const auto& point : EnclosePoints(element, 60, error, random))
    {
      EXPECT_TRUE(Holds(point.interval[0], point.truth[0])) << error;
      finite += point.interval[0].IsFinite() ? 1 : 0;
    }
    EXPECT_GE(finite, 55) << error;
  }
}

/// Far from any preimage, or with two preimages, each interval must be unbounded or contain the
/// value at the preimage that Newton's iteration finds from the same start.
TEST(Enclosure, NeverGuesses)
{
  Random random(6);
  for (const double error : { 1e-3, 1e-1, 1.0 })
  {
    CheckCase({}, 200, error, random);
  }
  // x = xi^2 in the first coordinate: singular at 0, with two preimages around.
  MeshBuilder builder;
  builder.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) {
      return LongVec3{ xi[0] * xi[0], xi[1], xi[2] };
    });
  ExpansionBuilder values(1);
  values.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi, long double* value) { value[0] = xi[0]; });
  const Mesh mesh = builder.View();
  const Field field{ "u", values.View() };
  int finite = 0;
  for (int k = 0; k < 400; ++k)
  {
    const double root = k == 0 ? 0.0 : std::ldexp(1.0, -k / 8) * (k % 2 == 0 ? 1.0 : -1.0);
    const Vec3 xi(root * (1.0 + 1e-15 * random()), 0.0, 0.0);
    const Vec3 x(root * root, 0.0, 0.0);
    const Interval value = Enclose(mesh, field, { &xi, 1 }, { &x, 1 })[0][0];
    // The stored square is rounded, and so is the root.
    const double slack = 1e-15 * std::fabs(root);
    EXPECT_TRUE(value.lower <= root + slack && value.upper >= root - slack) << root;
    EXPECT_FALSE(value.IsFinite() && value.Contains(0.0));
    finite += value.IsFinite() ? 1 : 0;
  }
  EXPECT_GT(finite, 100);
  EXPECT_LT(finite, 400);
}

/// The lanes of every instruction set, with and without fused operations.
TEST(Enclosure, HoldsOnEveryInstructionSet)
{
  OnEveryInstructionSet(
    []
    {
      Random random(12);
      for (const auto& [shape, form] : ShapesAndForms())
      {
        EnclosureCase c;
        c.shape = shape;
        c.form = form;
        c.mapping = Mapping::Contravariant;
        c.components = 3;
        EXPECT_EQ(CheckCase(c, 24, 1e-15, random).everything, 0);
      }
    });
}
} // namespace pixelexact::testing
