// SPDX-License-Identifier: BSD-3-Clause
// Certified ranges against values in 113 bits on dense grids, against closed forms, and against
// what quadratic tightening means.
#include "RangeCases.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
namespace
{
constexpr Space kTensorPyramid{ Shape::Pyramid, Form::Tensor, { 2, 2, 3 } };

/// The map that suits a space: curved, single-valued at a pyramid's apex.
MeshBuilder::Map MapFor(const Space& space)
{
  if (space.shape == Shape::Pyramid)
  {
    return [](const LongVec3& xi)
    {
      const auto [a, b, c] = xi;
      return LongVec3{ a + 0.1L * c * c, b + 0.08L * c * (1 + c) - 0.1L * a, c + 0.05L * b };
    };
  }
  return Curved;
}

/// Compares a range with a grid of n^3 points of the part.
void CheckOnGrid(const RangeCase& one, const RangeQuestion& question, const CertifiedRange& range,
  const Box3& part, int n)
{
  ASSERT_TRUE(range.finite);
  Quad least(1e300);
  Quad most(-1e300);
  for (int i = 0; i < n * n * n; ++i)
  {
    Vec3 eta;
    const int index[3] = { i / (n * n), i / n % n, i % n };
    for (int d = 0; d < 3; ++d)
    {
      const double along = static_cast<double>(index[d]) / (n - 1);
      eta[d] =
        index[d] == n - 1 ? part.upper[d] : part.lower[d] + along * (part.upper[d] - part.lower[d]);
    }
    if (one.mesh.ShapeOf(0) == Shape::Pyramid && eta.z == 1.0)
    {
      eta.z = 1.0 - 0x1p-30;
    }
    const Quad exact = QuantityQuad(one, question, eta);
    EXPECT_TRUE(Holds(range.outer, question, exact))
      << Name(one.mesh.ShapeOf(0)) << " quantity " << static_cast<int>(question.quantity) << ": "
      << static_cast<double>(exact) << " in " << range.outer.lower << " " << range.outer.upper;
    least = exact < least ? exact : least;
    most = most < exact ? exact : most;
  }
  EXPECT_LE(range.outer.lower, range.outer.upper);
  if (range.met)
  {
    // Attained values lie within the outer ends, and these are near the grid's extremes.
    EXPECT_GE(range.attained.lower, range.outer.lower);
    EXPECT_LE(range.attained.upper, range.outer.upper);
  }
}
} // namespace

TEST(Ranges, HoldDenseSamplesOnAllShapesAndOrders)
{
  Random random(41);
  int met = 0;
  int all = 0;
  std::vector<Space> spaces{ kTensorPyramid };
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3, 5, 8 })
    {
      spaces.push_back(UniformSpace(shape, order));
    }
  }
  for (const Space& space : spaces)
  {
    const Space mapSpace = space.form == Form::Tensor ? space : UniformSpace(space.shape, 3);
    RangeCase one(mapSpace, MapFor(space));
    one.Close();
    one.SetField(space, RandomModes(space, random, 1, 0.5));
    const Box3 part{ { -1.0, -0.3, 0.125 }, { 0.7, 0.9, 1.0 } };
    for (const Box3& box : { kWholeElement, part })
    {
      for (const RangeQuestion& question : QuestionsOf(one))
      {
        const CertifiedRange range = RangeOf(one.mesh, 0, question, { 5e-2, 1000 }, box);
        CheckOnGrid(one, question, range, box, space.MaxOrder() > 3 ? 4 : 6);
        met += range.met ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_GE(met, all * 9 / 10);
}

TEST(Ranges, HoldDenseSamplesOfMappedFields)
{
  Random random(42);
  for (const Shape shape : kShapes)
  {
    const Space space = UniformSpace(shape, 3);
    RangeCase one(UniformSpace(shape, 3), MapFor(space), Vec3(0.0), 0.25);
    for (const Mapping mapping : { Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
    {
      const int components = mapping == Mapping::Density ? 1 : 3;
      one.SetField(space, RandomModes(space, random, components, 0.5), components, mapping);
      for (const RangeQuestion& question : QuestionsOf(one))
      {
        const CertifiedRange range = RangeOf(one.mesh, 0, question, { 1e-2, 500 });
        CheckOnGrid(one, question, range, kWholeElement, 5);
      }
    }
    EXPECT_THROW(
      (void)RangeOf(one.mesh, 0, { Quantity::GradientMagnitude, &one.field }), Unsupported);
  }
}

TEST(Ranges, OrdersSixteenAndThirtyTwo)
{
  Random random(43);
  const auto check = [&random](const Space& space, double decay)
  {
    RangeCase one(UniformSpace(space.shape, 3), MapFor(space));
    one.SetField(space, RandomModes(space, random, 1, decay));
    const RangeQuestion question{ Quantity::Component, &one.field };
    const CertifiedRange range = RangeOf(one.mesh, 0, question, { 5e-2, 1500 });
    EXPECT_TRUE(range.met) << Name(space.shape) << decay;
    CheckOnGrid(one, question, range, kWholeElement, 3);
  };
  for (const Shape shape : kShapes)
  {
    check(UniformSpace(shape, 16), 0.7);
  }
  // Modes that do not decay: converted on 64 and on 512 pieces.
  check(UniformSpace(Shape::Tetrahedron, 16), 1.0);
  check(UniformSpace(Shape::Hexahedron, 32), 0.8);
}

TEST(Ranges, TightenQuadratically)
{
  // Boxes that shrink about an interior point: at each bisection the excess of the enclosure over
  // the range of values decreases at least by a factor of four.
  Random random(45);
  for (const Shape shape : kShapes)
  {
    const Space space = UniformSpace(shape, 4);
    RangeCase one(UniformSpace(shape, 3), MapFor(space));
    one.SetField(space, RandomModes(space, random, 1, 0.6));
    for (const RangeQuestion& question : QuestionsOf(one))
    {
      double before = 0.0;
      for (double w = 0x1p-4; w > 0x1p-9; w /= 2.0)
      {
        const Box3 box{ Vec3(-0.3) - Vec3(w), Vec3(-0.3) + Vec3(w) };
        const CertifiedRange one8 = RangeOf(one.mesh, 0, question, { 1e-9, 1 }, box);
        const CertifiedRange fine = RangeOf(one.mesh, 0, question, { 1e-6, 4000 }, box);
        const double excess =
          fine.attained.lower - one8.outer.lower + one8.outer.upper - fine.attained.upper;
        EXPECT_GE(excess, -1e-15);
        if (before > 1e-12)
        {
          EXPECT_LE(excess, before / 3.5) << Name(shape) << static_cast<int>(question.quantity);
        }
        before = excess;
      }
    }
  }
}

TEST(Ranges, ClosedForms)
{
  // On [-1,1]^3: f = x^2 + y^2 - z with the gradient (2x, 2y, -1).
  const Space space = UniformSpace(Shape::Hexahedron, 2);
  RangeCase one(
    UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& xi) {
      return LongVec3{ 4 * xi[0], 4 * xi[1], 4 * xi[2] };
    },
    Vec3(0.0), 4.0);
  ExpansionBuilder builder(1);
  builder.Add(space,
    [](const LongVec3& xi, long double* value)
    { *value = 16 * (xi[0] * xi[0] + xi[1] * xi[1]) - 4 * xi[2]; });
  one.SetField(space, builder.Coefficients);
  const auto near = [&](Quantity quantity, double lower, double upper, int direction = 0)
  {
    const CertifiedRange range =
      RangeOf(one.mesh, 0, { quantity, &one.field, 0, direction }, { 1e-4, 4000 });
    EXPECT_TRUE(range.met);
    EXPECT_LE(range.outer.lower, lower + 1e-12);
    EXPECT_GE(range.outer.upper, upper - 1e-12);
    EXPECT_NEAR(range.outer.lower, lower, 1e-4 * (upper - lower) + 1e-10);
    EXPECT_NEAR(range.outer.upper, upper, 1e-4 * (upper - lower) + 1e-10);
    EXPECT_GE(range.attained.lower, lower - 1e-12);
    EXPECT_LE(range.attained.upper, upper + 1e-12);
  };
  near(Quantity::Component, -4.0, 36.0);
  near(Quantity::GradientMagnitude, 1.0, std::sqrt(129.0));
  near(Quantity::GradientComponent, -8.0, 8.0, 1);
  near(Quantity::GradientComponent, -1.0, -1.0, 2);
  near(Quantity::Jacobian, 64.0, 64.0);
}

TEST(Ranges, SizesAndMagnitudesFromOneEndToTheOther)
{
  Random random(46);
  for (const double size : { 0x1p-480, 0x1p480 })
  {
    for (const double magnitude : { 0x1p-1000, 0x1p1000 })
    {
      const Space space = UniformSpace(Shape::Prism, 3);
      RangeCase one(
        space,
        [size](const LongVec3& xi)
        {
          const LongVec3 x = Curved(xi);
          return LongVec3{ x[0] * size, x[1] * size, x[2] * size };
        },
        Vec3(0.0), size);
      auto modes = RandomModes(space, random, 1, 0.5);
      for (double& c : modes)
      {
        c *= magnitude;
      }
      one.SetField(space, modes);
      for (const RangeQuestion& question : QuestionsOf(one))
      {
        const CertifiedRange range = RangeOf(one.mesh, 0, question, { 1e-2, 500 });
        EXPECT_TRUE(range.met);
        EXPECT_FALSE(range.outer.IsEmpty());
        if (question.quantity != Quantity::Magnitude &&
          question.quantity != Quantity::GradientMagnitude)
        {
          CheckOnGrid(one, question, range, kWholeElement, 3);
        }
      }
    }
  }
}

TEST(Ranges, ZeroAndConstantsAreExact)
{
  for (const Shape shape : kShapes)
  {
    for (const Mapping mapping :
      { Mapping::Identity, Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
    {
      const int components = mapping == Mapping::Density ? 1 : 3;
      RangeCase one(UniformSpace(shape, 4), MapFor(UniformSpace(shape, 4)));
      const Space space = UniformSpace(shape, 3);
      const auto modes = static_cast<std::size_t>(space.Modes());
      one.SetField(space, std::vector<double>(modes * static_cast<std::size_t>(components), 0.0),
        components, mapping);
      for (const RangeQuestion& question : QuestionsOf(one))
      {
        if (question.quantity != Quantity::Jacobian)
        {
          const CertifiedRange range = RangeOf(one.mesh, 0, question);
          EXPECT_EQ(range.outer.lower, 0.0) << Name(shape);
          EXPECT_EQ(range.outer.upper, 0.0) << Name(shape);
          EXPECT_TRUE(range.met);
          const MeshRange all = RangeOf(one.mesh, question, {});
          EXPECT_EQ(all.range.outer.lower, 0.0);
          EXPECT_EQ(all.range.outer.upper, 0.0);
        }
      }
      // A constant in the first mode, which is 1.
      one.values[0] = 17.0 / 3.0;
      const CertifiedRange constant = RangeOf(one.mesh, 0, { Quantity::Component, &one.field, 0 });
      if (mapping == Mapping::Identity)
      {
        EXPECT_EQ(constant.outer.lower, 17.0 / 3.0);
        EXPECT_EQ(constant.outer.upper, 17.0 / 3.0);
      }
    }
  }
}

TEST(Ranges, MappedFieldsOfStraightElementsHoldDenseSamples)
{
  // The map is affine, so that only the field matters.
  Random random(77);
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    for (const Mapping mapping :
      { Mapping::Identity, Mapping::Covariant, Mapping::Contravariant, Mapping::Density })
    {
      const int components = mapping == Mapping::Density ? 1 : 3;
      RangeCase one(UniformSpace(shape, 1),
        [](const LongVec3& x) {
          return LongVec3{ 0.3L * x[0] + 0.1L * x[1], x[1] - 0.7L * x[2], 2.0L * x[2] + x[0] };
        });
      const Space space = UniformSpace(shape, 3);
      one.SetField(space, RandomModes(space, random, components, 0.5), components, mapping);
      for (const RangeQuestion& question : QuestionsOf(one))
      {
        const CertifiedRange range = RangeOf(one.mesh, 0, question);
        EXPECT_TRUE(range.met) << Name(shape);
        EXPECT_LE(range.boxes, 2000) << Name(shape);
        CheckOnGrid(one, question, range, kWholeElement, 6);
      }
    }
  }
  // A linear field takes its ends at the vertices: one box is enough.
  RangeCase one(UniformSpace(Shape::Tetrahedron, 1),
    [](const LongVec3& x) {
      return LongVec3{ 0.3L * x[0], x[1] + 0.2L * x[0], x[2] };
    });
  const Space space = UniformSpace(Shape::Tetrahedron, 1);
  one.SetField(space, RandomModes(space, random, 3, 1.0), 3, Mapping::Covariant);
  EXPECT_EQ(RangeOf(one.mesh, 0, { Quantity::Component, &one.field, 1 }).boxes, 1);
}

TEST(Ranges, NotFiniteIsSaid)
{
  const Space space = UniformSpace(Shape::Tetrahedron, 2);
  RangeCase one(space, [](const LongVec3& xi) { return xi; });
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    std::vector<double> modes(space.Modes(), 1.0);
    modes[3] = bad;
    one.SetField(space, modes);
    const CertifiedRange range = RangeOf(one.mesh, 0, { Quantity::Component, &one.field });
    EXPECT_FALSE(range.finite);
    EXPECT_FALSE(range.met);
    EXPECT_FALSE(range.outer.IsFinite());
    const MeshRange mesh = RangeOf(one.mesh, { Quantity::Component, &one.field }, RangeEffort{});
    EXPECT_EQ(mesh.notFinite, 1);
    EXPECT_TRUE(mesh.range.outer.IsEmpty());
  }
  // The range of a component does not depend on the others.
  std::vector<double> two(2 * static_cast<std::size_t>(space.Modes()), 0.5);
  two.back() = std::numeric_limits<double>::quiet_NaN();
  one.SetField(space, two, 2);
  EXPECT_TRUE(RangeOf(one.mesh, 0, { Quantity::Component, &one.field, 0 }).met);
  EXPECT_FALSE(RangeOf(one.mesh, 0, { Quantity::Magnitude, &one.field }).finite);
  // A constant is known up to rounding, and nothing is attained beyond that.
  one.SetField(space, std::vector<double>(space.Modes(), 0.0));
  const CertifiedRange zero = RangeOf(one.mesh, 0, { Quantity::Component, &one.field });
  EXPECT_TRUE(zero.met);
  EXPECT_TRUE(zero.outer.Contains(0.0));
  EXPECT_NEAR(zero.outer.upper, 0.0, 1e-200);
}
} // namespace pixelexact::testing
