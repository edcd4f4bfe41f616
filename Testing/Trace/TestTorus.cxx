// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "Trace/Surfaces/Torus.h"

#include <glm/geometric.hpp>

namespace pixelexact::testing
{
namespace
{
/// Centre, axis a, R, r; times a.a.
const auto kTorus = [](const std::vector<Float128>& in, const auto& x)
{
  using T = std::decay_t<decltype(x[0])>;
  const auto y = Less(x, in.data());
  const Float128* a = in.data() + 3;
  const Float128 aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  const Float128 R = in[6];
  const Float128 r = in[7];
  const T square = Square(y);
  const T along = DotWith(y, a);
  const T sphere = square + T(R * R - r * r);
  return T(aa) * sphere * sphere - T(4 * R * R) * (T(aa) * square - along * along);
};

/// Rays through the tube's cross sections, from near and far, along the circle and from inside.
std::vector<Ray> TubeRays(
  RaysAbout& random, const Vec3& centre, const Vec3& axis, double R, double r, int count)
{
  std::vector<Ray> rays;
  const Vec3 unit = glm::normalize(axis);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 out = glm::normalize(glm::cross(unit, random.UnitVector()));
    const Vec3 around = glm::cross(unit, out);
    const Vec3 onCircle = centre + R * out;
    const Vec3 in = onCircle + random.Vector(r);
    const double far =
      (R + r) * random.Decades(-1.0, 2.0) + (i % 5 == 0 ? random.Decades(0.0, 8.0) : 0.0);
    Vec3 along;
    switch (i % 5)
    {
      case 0:
        rays.push_back(random.Through(in, far));
        break;
      case 1:
        // Across the hole: four hits.
        along = glm::normalize(onCircle - centre + random.Vector(0.5 * r));
        rays.push_back({ centre - far * along, along });
        break;
      case 2:
        // Nearly along the circle.
        along = glm::normalize(around + random.Decades(-8.0, 0.0) * random.UnitVector());
        rays.push_back({ in - far * along, along });
        break;
      case 3:
        rays.push_back({ in, random.UnitVector() });
        break;
      default:
        rays.push_back(random.Through(centre + random.Vector(1.2 * (R + r)), far));
    }
  }
  return rays;
}

void CheckTori(SurfaceCheck& check, RaysAbout& random, double leastRatio, double mostRatio)
{
  for (int k = 0; k < 8; ++k)
  {
    const double r = random.Decades(-6.0, 4.0);
    const double R = r / random.Decades(leastRatio, mostRatio);
    const Vec3 centre = random.Vector(k % 3 == 0 ? 0.0 : R * random.Decades(-2.0, 3.0));
    const Vec3 axis = k % 4 == 0 ? Vec3(0.0, 0.0, 3.0) : 2.0 * random.UnitVector();
    // The quartic is rounded as the larger radius is.
    const double preparation = 0x1p-92 * (1.0 + R / r);
    check.Add(Torus(centre, axis, R, r),
      Definition{ Numbers({ centre, axis }, { R, r }), kTorus, preparation },
      TubeRays(random, centre, axis, R, r, 37), centre, r, random);
  }
}
/// Hits of rays that graze, each moved to the origin: there a position shows every bit of its root.
void CheckAtTheOrigin(SurfaceCheck& check, RaysAbout& random)
{
  for (int k = 0; k < 16; ++k)
  {
    const double r = random.Decades(-3.0, 3.0);
    const double R = r / random.Decades(k % 4 == 0 ? -5.0 : -1.0, 0.5);
    const Vec3 axis = 2.0 * random.UnitVector();
    const double preparation = 0x1p-92 * (1.0 + R / r);
    const Torus torus(Vec3(0.0), axis, R, r);
    for (const Ray& ray : TubeRays(random, Vec3(0.0), axis, R, r, 4))
    {
      for (const Hit& at : HitsOf(torus, ray))
      {
        const Ray grazing = random.Grazing(at.position, torus.Normal({ at.position }),
          random.Sign() * r * random.Decades(-15.0, -1.0), r * random.Decades(-1.0, 1.0));
        for (const Hit& hit : HitsOf(torus, grazing))
        {
          const Vec3 centre = -hit.position;
          check.Add(Torus(centre, axis, R, r),
            Definition{ Numbers({ centre, axis }, { R, r }), kTorus, preparation },
            { Ray{ grazing.origin - hit.position, grazing.direction } }, centre, r, random);
        }
      }
    }
  }
}
} // namespace

TEST(Torus, RingsAreMetAsDefined)
{
  SurfaceCheck check(11);
  check.Run([&](RaysAbout& random) { CheckTori(check, random, -1.5, -0.01); });
  EXPECT_GT(check.Result().certain, 300);
  EXPECT_GT(check.Result().uncertain, 20);
  EXPECT_GT(check.Result().hits, 600);
}

TEST(Torus, ThinRingsAreMetAsDefined)
{
  SurfaceCheck check(12);
  check.Run([&](RaysAbout& random) { CheckTori(check, random, -6.0, -2.0); });
  EXPECT_GT(check.Result().certain, 300);
  EXPECT_GT(check.Result().uncertain, 20);
  EXPECT_GT(check.Result().hits, 500);
}

TEST(Torus, SpindlesAreMetAsDefined)
{
  SurfaceCheck check(13);
  check.Run([&](RaysAbout& random) { CheckTori(check, random, 0.01, 3.0); });
  EXPECT_GT(check.Result().certain, 300);
  EXPECT_GT(check.Result().uncertain, 20);
  EXPECT_GT(check.Result().hits, 600);
}

TEST(Torus, RootsAreRightInAllTheirBits)
{
  SurfaceCheck check(14);
  check.Run([&](RaysAbout& random) { CheckAtTheOrigin(check, random); });
  EXPECT_GT(check.Result().certain, 100);
  EXPECT_GT(check.Result().hits, 200);
}

TEST(Torus, FourHitsInOrderAndWithinTheRaysEnds)
{
  const Torus torus(Vec3(0.0), { 0.0, 0.0, 1.0 }, 2.0, 0.5);
  const Ray ray{ { -4.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto hits = HitsOf(torus, ray);
  ASSERT_EQ(hits.size(), 4U);
  const double expected[] = { 1.5, 2.5, 5.5, 6.5 };
  for (std::size_t k = 0; k < 4; ++k)
  {
    EXPECT_EQ(hits[k].t, expected[k]);
    EXPECT_EQ(hits[k].position, Vec3(expected[k] - 4.0, 0.0, 0.0));
    EXPECT_EQ(hits[k].status, HitStatus::Certain);
  }
  const auto some = HitsOf(torus, ray, 2.5, 5.5);
  ASSERT_EQ(some.size(), 2U);
  EXPECT_EQ(some[0].t, 2.5);
  EXPECT_EQ(some[1].t, 5.5);
  EXPECT_TRUE(HitsOf(torus, ray, 3.0, 2.0).empty());
  EXPECT_TRUE(HitsOf(torus, { { 0.0, 0.0, -4.0 }, { 0.0, 0.0, 1.0 } }).empty());
}

TEST(Torus, MayBeOfAnySize)
{
  for (const double size : { 1e-90, 1e-30, 1e30, 1e90 })
  {
    const Torus torus(Vec3(0.0), { 0.0, 0.0, 1e-200 }, 2.0 * size, 0.5 * size);
    const auto hits = HitsOf(torus, { { -4.0 * size, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } });
    ASSERT_EQ(hits.size(), 4U);
    const double expected[] = { 1.5, 2.5, 5.5, 6.5 };
    for (std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(hits[k].t / size, expected[k], 1e-14);
      EXPECT_NEAR(std::fabs(torus.Normal({ hits[k].position }).x), 1.0, 1e-14);
    }
  }
}

TEST(Torus, TouchesOnceAndIsUndecided)
{
  const Torus torus(Vec3(0.0), { 0.0, 0.0, 1.0 }, 2.0, 0.5);
  const auto expectTouches = [&](const Ray& ray, std::initializer_list<double> at)
  {
    const auto hits = HitsOf(torus, ray);
    ASSERT_EQ(hits.size(), at.size());
    std::size_t k = 0;
    for (const double t : at)
    {
      EXPECT_NEAR(hits[k].t, t, 1e-7);
      EXPECT_EQ(hits[k].status, HitStatus::Undecided);
      ++k;
    }
  };
  // The outer equator, and the circle on top, crossed twice.
  expectTouches({ { 2.5, -3.0, 0.0 }, { 0.0, 1.0, 0.0 } }, { 3.0 });
  expectTouches({ { -4.0, 0.0, 0.5 }, { 1.0, 0.0, 0.0 } }, { 2.0, 6.0 });
  // A torus whose numbers are all inexact.
  const Torus odd(Vec3(0.0), { 0.0, 0.0, 1.0 }, 2.1, 0.3);
  for (const double y : { 0.1, 0.7, 1.3, 1.9 })
  {
    const auto found = HitsOf(odd, { { -4.0, y, 0.3 }, { 1.0, 0.0, 0.0 } });
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].t, 4.0 - std::sqrt(2.1 * 2.1 - y * y), 1e-14);
    EXPECT_EQ(found[0].status, HitStatus::Undecided);
    EXPECT_EQ(found[1].status, HitStatus::Undecided);
  }
  // Its centre, by the horn torus.
  const Torus horn(Vec3(0.0), { 0.0, 0.0, 1.0 }, 1.0, 1.0);
  const auto hits = HitsOf(horn, { { 0.0, 0.0, -2.0 }, { 0.0, 0.0, 1.0 } });
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].status, HitStatus::Undecided);
  EXPECT_EQ(glm::length(horn.Normal({ hits[0].position })), 1.0);
}

TEST(Torus, NormalsPointAwayFromTheCircle)
{
  const Vec3 axis = glm::normalize(Vec3(1.0, 2.0, -0.5));
  const Vec3 out = glm::normalize(glm::cross(axis, Vec3(0.0, 1.0, 0.0)));
  for (const double r : { 0.25, 3.0 })
  {
    const Torus torus(Vec3(1.0, 0.0, -2.0), 7.0 * axis, 1.0, r);
    for (int i = 0; i < 40; ++i)
    {
      const double angle = 0.157 * i;
      const Vec3 normal = std::cos(angle) * out + std::sin(angle) * axis;
      const Vec3 x = Vec3(1.0, 0.0, -2.0) + out + r * normal;
      const Vec3 found = torus.Normal({ x });
      EXPECT_LE(glm::length(glm::cross(found, normal)), 1e-14) << i;
      EXPECT_NEAR(glm::length(found), 1.0, 1e-15);
    }
  }
}

TEST(Torus, RefusesWhatIsNoTorus)
{
  const Vec3 up(0.0, 0.0, 1.0);
  const auto message = [](const Vec3& centre, const Vec3& axis, double R, double r)
  { return MessageOf([&] { Torus(centre, axis, R, r); }); };
  EXPECT_EQ(
    message(Vec3(0.0), up, 0.0, 1.0), "torus: its radius is not positive; give one that is.");
  EXPECT_EQ(
    message(Vec3(0.0), up, 1.0, -1.0), "torus: its radius is not positive; give one that is.");
  EXPECT_EQ(message(Vec3(0.0), up, kNoHit, 1.0),
    "torus: its radius is out of range; give one between 1e-100 and 1e100.");
  EXPECT_EQ(message(Vec3(0.0), up, 1.0, 1e-9),
    "torus: one radius is more than 1e8 times the other; give a cylinder or a sphere.");
  EXPECT_EQ(message(Vec3(0.0), Vec3(0.0), 1.0, 0.5), "torus: its axis is zero; give a direction.");
  EXPECT_EQ(message(Vec3(kNoHit), up, 1.0, 0.5),
    "torus: a coordinate of its position is not a finite number.");
}
} // namespace pixelexact::testing
