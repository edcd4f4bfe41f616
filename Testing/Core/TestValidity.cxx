// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on elements whose det J is known in closed form, down to the limit that rounding sets.
#include "RangeCases.h"

#include "Core/Element/MeshRanges.h"
#include "Core/Element/Validity.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr RangeQuestion kJacobian{ Quantity::Jacobian };

ElementValidity Verdict(const Space& space, const MeshBuilder::Map& map,
  const Vec3& centre = Vec3(0.0), double size = 1.0)
{
  RangeCase one(space, map, centre, size);
  one.Close();
  return ValidityOf(one.mesh, 0);
}

/// The trilinear cube whose corner (1,1,1) is moved to (1 - d, 1 - d, 1 - d); there
/// det J = 1 - 3 d / 2, its least value for d > 0.
LongVec3 PushedCorner(const LongVec3& xi, long double d)
{
  const long double bubble = (1 + xi[0]) * (1 + xi[1]) * (1 + xi[2]) / 8;
  return { xi[0] - d * bubble, xi[1] - d * bubble, xi[2] - d * bubble };
}

/// A quadratic element in x of whose edges from (-1,-1,-1) along xi1 the middle node is moved by d
/// along the edge: det J = 1 - 2 d xi1 ... on that edge, of either sign at its ends for |d| > 1/2.
LongVec3 MovedMiddle(const LongVec3& xi, long double d)
{
  const long double along = (1 + xi[0]) / 2;
  const long double rest = -(1 + xi[0] + xi[1] + xi[2]) / 2; // barycentric, of the first vertex
  return { xi[0] + 4 * along * rest * d, xi[1], xi[2] };
}
} // namespace

TEST(Validity, PushedCornerOfAHexahedron)
{
  const Space space = UniformSpace(Shape::Hexahedron, 1);
  for (const double d : { 0.0, 0.3, 0.6, 0.66 })
  {
    const auto found = Verdict(space, [d](const LongVec3& xi) { return PushedCorner(xi, d); });
    EXPECT_EQ(found.validity, Validity::Valid) << d;
    EXPECT_LE(found.jacobian.outer.lower, 1 - 1.5 * d + 1e-12);
    EXPECT_NEAR(found.jacobian.attained.lower, 1 - 1.5 * d, 1e-3);
  }
  for (const double d : { 0.67, 0.7, 1.0, 3.0 })
  {
    const auto found = Verdict(space, [d](const LongVec3& xi) { return PushedCorner(xi, d); });
    EXPECT_EQ(found.validity, Validity::Inverted) << d;
    EXPECT_LE(found.jacobian.attained.lower, 0.0);
  }
}

TEST(Validity, MovedMiddleOfATetrahedron)
{
  // dx/dxi1 = 1 + 2 d (rest - along), of least value 1 - 2 |d| at an end of the edge.
  const Space space = UniformSpace(Shape::Tetrahedron, 2);
  for (const double d : { 0.1, -0.4, 0.49, 0.499999 })
  {
    const auto found = Verdict(space, [d](const LongVec3& xi) { return MovedMiddle(xi, d); });
    EXPECT_EQ(found.validity, Validity::Valid) << d;
    EXPECT_LE(found.jacobian.outer.lower, 1 - 2 * std::fabs(d) + 1e-12);
  }
  for (const double d : { 0.500001, -0.51, 0.7 })
  {
    const auto found = Verdict(space, [d](const LongVec3& xi) { return MovedMiddle(xi, d); });
    EXPECT_EQ(found.validity, Validity::Inverted) << d;
  }
  // det J vanishes at a vertex exactly, which rounded numbers cannot decide.
  const auto touching = Verdict(space, [](const LongVec3& xi) { return MovedMiddle(xi, 0.5L); });
  EXPECT_NE(touching.validity, Validity::Valid);
}

TEST(Validity, SmallDeterminantInsideOfAnElement)
{
  // det J = a^2 + b^2 + c^2 + e: of least value e at a point inside.
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    const Space space = UniformSpace(shape, 3);
    for (const double e : { 1e-3, 1e-6 })
    {
      const auto map = [e](double sign)
      {
        return [e, sign](const LongVec3& xi)
        {
          const long double a = xi[0] + 0.52L;
          const long double b = xi[1] + 0.47L;
          const long double c = xi[2] + 0.55L;
          const long double least = sign * e;
          return LongVec3{ a * (a * a / 3 + b * b + c * c + least), b, c };
        };
      };
      const auto valid = Verdict(space, map(1.0));
      EXPECT_EQ(valid.validity, Validity::Valid) << Name(shape) << e;
      EXPECT_NEAR(valid.jacobian.attained.lower, e, 1e-2);
      EXPECT_EQ(Verdict(space, map(-1.0)).validity, Validity::Inverted) << Name(shape) << e;
    }
  }
}

TEST(Validity, EveryShapeCurvedMirroredFlatAndOfAnySize)
{
  const auto curved = [](const LongVec3& xi)
  {
    const auto [a, b, c] = xi;
    return LongVec3{ a + 0.1L * c * c, b + 0.08L * c * (1 + c) - 0.1L * a, c + 0.05L * b };
  };
  std::vector<Space> spaces{ { Shape::Pyramid, Form::Tensor, { 2, 2, 3 } } };
  for (const Shape shape : kShapes)
  {
    for (const int order : { 2, 4, 7 })
    {
      spaces.push_back(UniformSpace(shape, order));
    }
  }
  for (const Space& space : spaces)
  {
    EXPECT_EQ(Verdict(space, curved).validity, Validity::Valid)
      << Name(space.shape) << space.MaxOrder();
    const auto mirrored = [&](const LongVec3& xi)
    {
      const LongVec3 x = curved(xi);
      return LongVec3{ x[0], -x[1], x[2] };
    };
    EXPECT_EQ(Verdict(space, mirrored).validity, Validity::Inverted);
    if (space.MaxOrder() > 4 || space.form == Form::Tensor)
    {
      continue;
    }
    const auto flat = [&](const LongVec3& xi)
    {
      const LongVec3 x = curved(xi);
      return LongVec3{ x[0], x[1], 0.3L * x[0] - 0.7L * x[1] };
    };
    EXPECT_EQ(Verdict(space, flat).validity, Validity::Undecided);
    for (const double size : { 0x1p-500, 0x1p500 })
    {
      const auto scaled = [&](const LongVec3& xi)
      {
        const LongVec3 x = curved(xi);
        return LongVec3{ x[0] * size, x[1] * size, x[2] * size };
      };
      // det J under- or overflows in world units; the verdict does not mind.
      const auto found = Verdict(space, scaled, Vec3(0.0), size);
      EXPECT_EQ(found.validity, Validity::Valid) << Name(space.shape) << size;
      EXPECT_GE(found.jacobian.outer.upper, size > 1.0 ? 1e308 : 0.0);
    }
  }
}

TEST(Validity, ABoundJustBelowZeroIsSubdivided)
{
  // det J = c (3 a X^2 + 1) >= c: over the whole element its hull reaches down to about 0 for
  // a = 1, and below for larger a.
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    for (const long double a : { 0.3L, 0.5L, 2.0L / 3.0L, 1.0L, 4.0L / 3.0L, 2.0L })
    {
      for (const long double c : { 1.0L, 0.1L })
      {
        const auto map = [a, c](const LongVec3& x)
        {
          return LongVec3{ c * (a * x[0] * x[0] * x[0] + x[0]), 0.6L * x[1] - 0.8L * x[2],
            0.8L * x[1] + 0.6L * x[2] };
        };
        const auto found = Verdict(UniformSpace(shape, 3), map);
        EXPECT_EQ(found.validity, Validity::Valid)
          << Name(shape) << " " << static_cast<double>(a) << " " << static_cast<double>(c);
        EXPECT_GT(found.jacobian.outer.lower, 0.0);
      }
    }
  }
}

TEST(Validity, OpenPyramidsAreNotDecided)
{
  // At the apex x depends on eta1, so det J is undefined there.
  RangeCase one(
    { Shape::Pyramid, Form::Tensor, { 1, 1, 1 } }, [](const LongVec3& xi) { return xi; });
  one.Close();
  EXPECT_EQ(ValidityOf(one.mesh, 0).validity, Validity::Valid);
  one.builder.Phi.Coefficients[6] += 1e-3;
  EXPECT_EQ(ValidityOf(one.mesh, 0).validity, Validity::Undecided);
}

TEST(Validity, WholeMeshesAndProgress)
{
  MeshBuilder builder;
  Random random(44);
  std::vector<double> expected;
  for (int e = 0; e < 60; ++e)
  {
    const long double d = random(0.0, 0.6);
    builder.Add(
      UniformSpace(Shape::Hexahedron, 1), [d](const LongVec3& xi) { return PushedCorner(xi, d); });
    expected.push_back(static_cast<double>(1 - 1.5L * d));
  }
  const Mesh mesh = builder.View();
  double told = 0.0;
  const auto tell = [&told](double part)
  {
    EXPECT_GE(part, told);
    told = part;
  };
  for (const ElementValidity& one : ValidityOf(mesh, RangeEffort{}, tell))
  {
    EXPECT_EQ(one.validity, Validity::Valid);
  }
  EXPECT_EQ(told, 1.0);
  told = 0.0;
  const MeshRange range = RangeOf(mesh, kJacobian, RangeEffort{}, tell);
  EXPECT_EQ(told, 1.0);
  const auto least = std::ranges::min_element(expected);
  EXPECT_EQ(range.lowerElement, least - expected.begin());
  EXPECT_TRUE(range.range.met);
  EXPECT_LE(range.range.outer.lower, *least + 1e-14);
  EXPECT_GE(range.range.outer.lower, *least - 2e-3);
  EXPECT_LE(range.range.attained.lower, *least + 1e-3);
  EXPECT_EQ(range.notFinite + range.unbounded, 0);
}
} // namespace pixelexact::testing
