// SPDX-License-Identifier: BSD-3-Clause
// Bounds of second derivatives by world coordinates against closed forms and against differences in
// 113 bits, which know nothing of the chain rule.
#include "MeshBuilder.h"
#include "QuadLine.h"
#include "RangeCases.h"

#include "Core/Base/Error.h"
#include "Core/Element/HessianRange.h"
#include "Core/Questions/Questions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace pixelexact::testing
{
namespace
{
LongVec3 Bent(const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  return { a + 0.1L * c * c, b + 0.08L * c * (1 + c) - 0.1L * a, c + 0.05L * b };
}

struct Case : RangeCase
{
  Case(Shape shape, const Vec3& centre = Vec3(0.0), double itsSize = 1.0)
    : RangeCase(
        UniformSpace(shape, shape == Shape::Pyramid ? 2 : 3),
        [=](const LongVec3& xi)
        {
          const LongVec3 x = shape == Shape::Pyramid ? Bent(xi) : Curved(xi);
          return Plus(ToLong(centre), Times(itsSize, x));
        },
        centre, itsSize)
  {
  }

  /// Second difference of F along a world direction.
  [[nodiscard]] double Difference(const Vec3& eta, const Vec3& direction) const
  {
    const QuadVec3 xi = ToXi(mesh.ShapeOf(0), { eta.x, eta.y, eta.z });
    const auto phi = EvaluateQuad(mesh.map, 0, xi);
    const Quad size(mesh.size[0]);
    const Quad step = Quad(1e-9) * size;
    const auto value = [&](const Quad& s)
    {
      QuadVec3 x;
      for (int d = 0; d < 3; ++d)
      {
        const auto at = static_cast<std::size_t>(d);
        x[at] = Quad(mesh.centre[at]) + size * phi[at].value + s * Quad(direction[d]);
      }
      return EvaluateQuad(field.values, 0, *Preimage(mesh, 0, x, xi))[0].value;
    };
    const Quad sum = value(step) + value(Quad(0) - step) - Quad(2) * value(0);
    return static_cast<double>(sum / step / step);
  }
};

Vec3 Direction(Random& random)
{
  return glm::normalize(Vec3(random(), random(), random()));
}
} // namespace

/// Of every shape and order; noise, and fields as smooth as a solver's.
TEST(HessianRange, HoldsDifferences)
{
  Random random(51);
  for (const double decay : { 0.3, 1.0 })
  {
    for (const Shape shape : kShapes)
    {
      double worst = 0.0;
      double worstNorm = 0.0;
      for (int order = 1; order <= 8; ++order)
      {
        Case one(shape, { 3.0, -2.0, 1.0 }, 0.25);
        one.SetNoise(order, random, decay);
        const Vec3 s = Direction(random);
        Box3 part = kWholeElement;
        if (order % 2 == 0 || shape == Shape::Pyramid)
        {
          part = { { -0.25, -1.0, -0.5 }, { 0.5, -0.25, 0.25 } };
        }
        const RangeEffort effort{ 0.05, 40 };
        const CertifiedRange along = HessianRange(one.mesh, 0, one.field, 0, s, s, effort, part);
        const CertifiedRange norm = HessianNormRange(one.mesh, 0, one.field, 0, effort, part);
        ASSERT_TRUE(along.outer.IsFinite() && norm.outer.IsFinite()) << Name(shape) << order;
        double largest = 0.0;
        for (int i = 0; i < 60; ++i)
        {
          Vec3 eta;
          for (int d = 0; d < 3; ++d)
          {
            // The ends, where extremes are likely; not the collapsed ones, where eta is not known.
            const double u = std::clamp(random(-0.3, 1.3), 0.0, 1.0);
            eta[d] = std::min(part.lower[d] + u * (part.upper[d] - part.lower[d]), 1.0 - 0x1p-20);
          }
          const double exact = one.Difference(eta, s);
          const double slack = 1e-12 * std::fabs(exact) + 1e-9;
          EXPECT_LE(exact, along.outer.upper + slack) << Name(shape) << order;
          EXPECT_GE(exact, along.outer.lower - slack) << Name(shape) << order;
          EXPECT_LE(std::fabs(exact), norm.outer.upper + slack);
          largest = std::max(largest, std::fabs(exact));
        }
        EXPECT_LE(along.attained.upper, along.outer.upper);
        if (largest > 0.0)
        {
          worst = std::max(worst, along.outer.Magnitude() / largest);
          worstNorm = std::max(worstNorm, norm.outer.upper / norm.attained.upper);
        }
      }
      std::cout << Name(shape) << ", decay " << decay << ": bound over samples at most " << worst
                << ", norm over attained " << worstNorm << '\n';
      EXPECT_LT(worst, 20.0);
      EXPECT_LT(worstNorm, 20.0);
    }
  }
}

/// A quadratic of world x has constant second derivatives, whatever the map: to rounding, also
/// where prisms and tetrahedra are collapsed.
TEST(HessianRange, QuadraticsOfWorldCoordinates)
{
  for (const Shape shape : { Shape::Hexahedron, Shape::Prism, Shape::Tetrahedron })
  {
    RangeCase one(UniformSpace(shape, 2), Bent);
    ExpansionBuilder made(1);
    made.Add(UniformSpace(shape, 4),
      [](const LongVec3& xi, long double* value)
      {
        const auto [x, y, z] = Bent(xi);
        *value = x * x - 3 * x * y + 0.5L * z * z + y - 7;
      });
    one.SetField(made.Spaces[0], made.Coefficients);
    const auto at = [&](const Vec3& a, const Vec3& b) {
      return HessianRange(one.mesh, 0, one.field, 0, a, b, { 1e-3, 300 }).outer;
    };
    const Vec3 x(1, 0, 0);
    const Vec3 y(0, 1, 0);
    const Vec3 z(0, 0, 1);
    const struct
    {
      Interval range;
      double exact;
    } known[] = { { at(x, x), 2.0 }, { at(x, y), -3.0 }, { at(y, x), -3.0 }, { at(y, y), 0.0 },
      { at(z, z), 1.0 }, { at(x + y, x - z), -1.0 } };
    for (const auto& [range, exact] : known)
    {
      EXPECT_TRUE(range.Contains(exact)) << Name(shape);
      EXPECT_LT(range.Width(), 0.5) << Name(shape) << ' ' << exact;
    }
    const CertifiedRange norm = HessianNormRange(one.mesh, 0, one.field, 0, { 1e-3, 300 });
    EXPECT_TRUE(norm.outer.Contains(std::sqrt(4.0 + 18.0 + 1.0)));
    EXPECT_LT(norm.outer.upper, 5.5);
  }
}

TEST(HessianRange, TightensQuadratically)
{
  Random random(52);
  for (const Shape shape : kShapes)
  {
    Case one(shape);
    one.SetNoise(4, random, 0.5);
    const Vec3 s = Direction(random);
    double last = 0.0;
    for (const double w : { 0.2, 0.1, 0.05 })
    {
      const Box3 part{ Vec3(-0.3 - w), Vec3(-0.3 + w) };
      const auto range = HessianRange(one.mesh, 0, one.field, 0, s, s, { 1e-9, 1 }, part);
      const double gap = range.GapAbove() + range.GapBelow();
      EXPECT_TRUE(last == 0.0 || gap < 0.35 * last) << Name(shape) << ' ' << gap << ' ' << last;
      last = gap;
    }
  }
}

TEST(HessianRange, SaysWhatIsNotBounded)
{
  Random random(53);
  const Vec3 x(1, 0, 0);
  // A pyramid's apex; not away from it.
  Case pyramid(Shape::Pyramid);
  pyramid.SetNoise(3, random, 0.5);
  EXPECT_FALSE(HessianNormRange(pyramid.mesh, 0, pyramid.field, 0, { 0.1, 50 }).outer.IsFinite());
  const Box3 below{ Vec3(-1.0), { 1.0, 1.0, 0.9 } };
  EXPECT_TRUE(
    HessianNormRange(pyramid.mesh, 0, pyramid.field, 0, { 0.1, 50 }, below).outer.IsFinite());

  // A map with det J = 0 at xi1 = -1.
  RangeCase flat(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi) {
      return LongVec3{ (1 + xi[0]) * (1 + xi[0]) / 4, xi[1], xi[2] };
    });
  flat.SetField(UniformSpace(Shape::Hexahedron, 1), { 0, 0, 0, 0, 1, 0, 0, 0 });
  EXPECT_FALSE(HessianRange(flat.mesh, 0, flat.field, 0, x, x).outer.IsFinite());
  const Box3 sound{ { 0.0, -1.0, -1.0 }, Vec3(1.0) };
  const auto range = HessianRange(flat.mesh, 0, flat.field, 0, x, x, {}, sound).outer;
  // F = 2 sqrt(x) - 1.
  EXPECT_TRUE(range.Contains(Interval(-4.0, -0.5)));
  EXPECT_LT(range.Width(), 3.6);

  flat.values[0] = std::numeric_limits<double>::quiet_NaN();
  flat.field.values.coefficients = flat.values;
  EXPECT_FALSE(HessianRange(flat.mesh, 0, flat.field, 0, x, x).finite);
  flat.field.mapping = Mapping::Density;
  EXPECT_THROW(HessianNormRange(flat.mesh, 0, flat.field, 0), Unsupported);
}

/// Over the nodes of a tree: ranges of values, and M of the second derivatives with which a field
/// between two points of a line is its chord up to M h^2 / 8.
TEST(HessianRange, ChordsOfNodes)
{
  Random random(54);
  for (const Shape shape : kShapes)
  {
    Case one(shape);
    one.SetNoise(4, random, 0.5);
    const ElementIndex index(one.mesh);
    const auto tree = index.TreeOf(0);
    ElementTree::Node* node = tree->Pieces()[0].get();
    for (int depth = 0; depth < 6; ++depth)
    {
      ASSERT_TRUE(tree->Split(*node));
      node = &node->Child(0);
    }
    const Box3 part = PartOf(*node);
    const RangeQuestion value{ Quantity::Component, &one.field, 0, 0 };
    const Interval values = RangeOf(one.mesh, 0, value, {}, part).outer;
    const double M = HessianNormRange(one.mesh, 0, one.field, 0, { 0.1, 20 }, part).outer.upper;
    const auto at = [&](const Vec3& eta) {
      return EvaluateQuad(one.field.values, 0, ToXi(shape, { eta.x, eta.y, eta.z }))[0].value;
    };
    const Vec3 middle = 0.5 * (part.lower + part.upper);
    EXPECT_TRUE(values.Contains(static_cast<double>(at(middle))));
    EXPECT_TRUE(std::isfinite(M));
    const QuadVec3 xi = ToXi(shape, { middle.x, middle.y, middle.z });
    const auto phi = EvaluateQuad(one.mesh.map, 0, xi);
    for (int repeat = 0; repeat < 10; ++repeat)
    {
      const Vec3 s = Direction(random);
      const double h = 1e-3;
      const auto along = [&](double by)
      {
        QuadVec3 x;
        for (int d = 0; d < 3; ++d)
        {
          x[static_cast<std::size_t>(d)] =
            phi[static_cast<std::size_t>(d)].value + Quad(by * h) * Quad(s[d]);
        }
        return EvaluateQuad(one.field.values, 0, *Preimage(one.mesh, 0, x, xi))[0].value;
      };
      const Quad sag = along(0.5) - Quad(0.5) * (along(0.0) + along(1.0));
      EXPECT_LE(std::fabs(static_cast<double>(sag)), M * h * h / 8);
    }
  }
}
} // namespace pixelexact::testing
