// SPDX-License-Identifier: BSD-3-Clause
// Where value enclosures end, and what they depend on.
#include "EnclosureCases.h"

#include <gtest/gtest.h>

namespace pixelexact::testing
{
TEST(EnclosureLimits, SaysNothingWhereNothingIsKnown)
{
  Random random(7);
  EnclosureElement element({}, random);
  const Mesh mesh = element.MeshView();
  const Vec3 xi(0.25, 0.5, -0.5);
  Vec3 x;
  MapForward(mesh, 0, { &xi, 1 }, { &x, 1 });
  const auto enclose = [&](const Vec3& at) {
    return Enclose(mesh, element.FieldView(), { &xi, 1 }, { &at, 1 })[0][0];
  };
  EXPECT_TRUE(enclose(x).IsFinite());
  const auto expectEverything = [](const Interval& value)
  {
    EXPECT_EQ(value.lower, -INFINITY);
    EXPECT_EQ(value.upper, INFINITY);
  };
  expectEverything(enclose({ NAN, x.y, x.z }));
  expectEverything(enclose({ x.x, INFINITY, x.z }));
  expectEverything(enclose(x + Vec3(0.5)));
  double& coefficient = element.Values.Coefficients[3];
  const double good = coefficient;
  for (const double bad : { double(NAN), double(INFINITY) })
  {
    coefficient = bad;
    expectEverything(enclose(x));
  }
  coefficient = good;
  element.Builder.Size[0] = 0.75;
  expectEverything(enclose(x));
  element.Builder.Size[0] = std::ldexp(1.0, -1000);
  expectEverything(enclose(x));
}

TEST(EnclosureLimits, CoversTheMeshsUncertainty)
{
  Random random(8);
  EnclosureElement element({}, random);
  element.Builder.Uncertainty[0] = 1e-9;
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  for (int k = 0; k < 100; ++k)
  {
    const Vec3 xi = random.Inside(Shape::Hexahedron);
    Vec3 x;
    MapForward(mesh, 0, { &xi, 1 }, { &x, 1 });
    const Vec3 other = x + 1e-9 * Vec3(random(), random(), random());
    const auto truth = WorldValuesQuad(mesh, field, 0, InvertQuad(mesh, 0, other, xi));
    const Interval wide = Enclose(mesh, field, { &xi, 1 }, { &x, 1 })[0][0];
    const Interval exact = Enclose(mesh, field, { &xi, 1 }, { &x, 1 }, { false })[0][0];
    EXPECT_TRUE(Holds(wide, truth[0]));
    EXPECT_TRUE(wide.Contains(exact));
    EXPECT_LT(wide.Width(), 1e-7);
    EXPECT_LT(exact.Width(), 1e-13);
  }
}

TEST(EnclosureLimits, AFieldThatIsZeroIsZero)
{
  Random random(12);
  for (const Mapping mapping : { Mapping::Identity, Mapping::Covariant })
  {
    EnclosureCase c;
    c.components = 3;
    c.mapping = mapping;
    EnclosureElement element(c, random);
    std::ranges::fill(element.Values.Coefficients, 0.0);
    const Vec3 xi(0.25, 0.5, -0.5);
    Vec3 x;
    MapForward(element.MeshView(), 0, { &xi, 1 }, { &x, 1 });
    const auto found = Enclose(element.MeshView(), element.FieldView(), { &xi, 1 }, { &x, 1 });
    for (const Interval& value : found[0])
    {
      EXPECT_EQ(value.lower, 0.0);
      EXPECT_EQ(value.upper, 0.0);
    }
  }
}

TEST(EnclosureLimits, DependsOnThePointAlone)
{
  Random random(9);
  const EnclosureElement element({}, random);
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  std::vector<Vec3> xi(21);
  for (auto& point : xi)
  {
    point = random.Inside(Shape::Hexahedron);
  }
  std::vector<Vec3> x(xi.size());
  MapForward(mesh, 0, xi, x);
  // Some that need more than one box, some that fail.
  for (std::size_t k = 0; k < xi.size(); k += 3)
  {
    xi[k].x += k % 2 == 0 ? 1e-7 : 0.3;
  }
  const auto together = Enclose(mesh, field, xi, x);
  for (std::size_t k = 0; k < xi.size(); ++k)
  {
    const auto alone = Enclose(mesh, field, { &xi[k], 1 }, { &x[k], 1 });
    EXPECT_EQ(alone[0][0].lower, together[k][0].lower);
    EXPECT_EQ(alone[0][0].upper, together[k][0].upper);
  }
}

TEST(EnclosureLimits, HoldsAtFacesEdgesAndVertices)
{
  Random random(10);
  for (const auto& [shape, form] : ShapesAndForms())
  {
    EnclosureCase c;
    c.shape = shape;
    c.form = form;
    const EnclosureElement element(c, random);
    const Mesh mesh = element.MeshView();
    const Field field = element.FieldView();
    for (int corner = 0; corner < 27; ++corner)
    {
      const Vec3 eta(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
      const bool apex = shape == Shape::Pyramid && eta.z == 1.0;
      const Vec3 xi = TensorToReference(shape, eta);
      Vec3 x;
      MapForward(mesh, 0, { &xi, 1 }, { &x, 1 });
      const Interval value = Enclose(mesh, field, { &xi, 1 }, { &x, 1 })[0][0];
      EXPECT_EQ(value.IsFinite(), !apex) << Name(shape) << " corner " << corner;
      if (!apex)
      {
        const auto truth = WorldValuesQuad(mesh, field, 0, InvertQuad(mesh, 0, x, xi));
        EXPECT_TRUE(Holds(value, truth[0])) << Name(shape) << " corner " << corner;
      }
    }
  }
}

TEST(EnclosureLimits, HoldsNearAPyramidsApex)
{
  Random random(11);
  EnclosureCase c;
  c.shape = Shape::Pyramid;
  const EnclosureElement element(c, random);
  const Mesh mesh = element.MeshView();
  const Field field = element.FieldView();
  for (int k = 4; k < 48; ++k)
  {
    const double t = std::ldexp(1.0, -k);
    const Vec3 xi = TensorToReference(Shape::Pyramid, { random(), random(), 1.0 - 2.0 * t });
    Vec3 x;
    MapForward(mesh, 0, { &xi, 1 }, { &x, 1 });
    const Interval value = Enclose(mesh, field, { &xi, 1 }, { &x, 1 })[0][0];
    const auto truth = WorldValuesQuad(mesh, field, 0, InvertQuad(mesh, 0, x, xi));
    EXPECT_TRUE(Holds(value, truth[0])) << t;
    // Down to where rounding of the point moves it by as much as a thousandth of its distance.
    EXPECT_TRUE(k > 36 || value.Width() < 1e-11) << t << " " << value.Width();
  }
}
} // namespace pixelexact::testing
