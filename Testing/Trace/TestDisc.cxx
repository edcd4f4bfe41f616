// SPDX-License-Identifier: BSD-3-Clause
#include "InstructionSets.h"
#include "RayCheck.h"
#include "SurfaceCheck.h"

#include "Trace/Surfaces/Disc.h"

#include <limits>

namespace pixelexact::testing
{
namespace
{
/// The points x with normal . (x - centre) = 0 and |x - centre| <= radius.
struct LongDisc
{
  LongPlane plane;
  long double radius;

  [[nodiscard]] std::vector<TrueHit> Meet(const Ray& ray) const
  {
    TrueHit hit = plane.Meet(ray);
    if (hit.certain)
    {
      const LongVec3 off = Minus(hit.position, plane.origin);
      const long double beyond = std::sqrt(Dot(off, off)) - radius;
      const long double slack = hit.error + RayError(ray, hit.t, plane.origin);
      if (beyond > slack)
      {
        return {};
      }
      hit.certain = beyond < -slack;
    }
    return { hit };
  }
};

/// A ray through the disc, near its rim or past it, from near and far, often nearly along it.
Ray RayNear(RandomRays& random, const Vec3& centre, const Vec3& normal, double radius)
{
  const LongVec3 unit = Unit(ToLong(normal));
  const LongVec3 aside = Unit(Cross(unit, ToLong(random.Vector(1.0))));
  const double kind = random.Vector(1.0).x;
  const double from = kind < 0.0 ? 2.0 * std::fabs(random.Vector(1.0).x)
                                 : 1.0 + (kind < 0.5 ? -1.0 : 1.0) * random.Size(-17.0, 0.0);
  const LongVec3 through = Plus(ToLong(centre), Times(from * radius, aside));
  LongVec3 along = ToLong(random.Vector(1.0));
  if (random.Vector(1.0).x < 0.0)
  {
    along = Plus(Cross(unit, along), Times(random.Size(-18.0, 0.0), unit));
  }
  along = Unit(along);
  const double distance = radius * random.Size(-2.0, 8.0);
  return { ToDouble(Minus(through, Times(distance, along))), ToDouble(along) };
}

void CheckRandomDiscs()
{
  RandomRays random(67);
  int certain = 0;
  int uncertain = 0;
  int none = 0;
  for (int k = 0; k < 300; ++k)
  {
    const double radius = random.Size(-6.0, 6.0);
    const Vec3 centre = random.Vector(k % 3 == 0 ? 0.0 : radius * random.Size(-2.0, 4.0));
    const Vec3 normal =
      random.Vector(random.Size(-200.0, 200.0)) * Vec3(1.0, random.Size(-6.0, 0.0), 1.0);
    const Disc disc(centre, normal, radius);
    const LongDisc truth{ { ToLong(centre), ToLong(normal) }, radius };
    EXPECT_LE(Largest(Minus(ToLong(disc.Normal({})), truth.plane.normal)), 4.0 * kUnitRoundoff);
    // More than one pack, and a part of one.
    std::vector<Ray> rays;
    std::vector<std::vector<TrueHit>> hits;
    std::vector<double> tNear;
    for (int i = 0; i < 53; ++i)
    {
      rays.push_back(RayNear(random, centre, normal, radius));
      hits.push_back(truth.Meet(rays.back()));
      const long double t = truth.plane.Meet(rays.back()).t;
      tNear.push_back(std::max(kNearest, random.Start(t)));
    }
    const auto found = AllHits(disc, rays, tNear);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      certain += ExpectHits(found[i], hits[i], tNear[i]);
      uncertain += !hits[i].empty() && !hits[i][0].certain ? 1 : 0;
      none += hits[i].empty() ? 1 : 0;
      EXPECT_LE(found[i].size(), 1U);
      for (const auto& [t, position, status] : found[i])
      {
        const LongVec3 x = ToLong(position);
        const LongVec3 at = Plus(ToLong(rays[i].origin), Times(t, ToLong(rays[i].direction)));
        EXPECT_LE(Largest(Minus(x, at)), RayError(rays[i], t, truth.plane.origin));
        EXPECT_LE(truth.plane.Distance(x), truth.plane.DistanceError(x));
        EXPECT_EQ(status, HitStatus::Certain);
      }
    }
  }
  // Some of each kind.
  EXPECT_GT(certain, 3000);
  EXPECT_GT(uncertain, 300);
  EXPECT_GT(none, 2000);
}
} // namespace

TEST(Disc, HitsAreOnRayAndDiscAndNoneIsMissing)
{
  OnEveryInstructionSet(CheckRandomDiscs);
}

TEST(Disc, EndsAtItsRim)
{
  const Disc disc({ 1.0, 2.0, 3.0 }, { 0.0, 0.0, -2.0 }, 5.0);
  EXPECT_TRUE(disc.IsFlat());
  EXPECT_EQ(disc.Normal({}), Vec3(0.0, 0.0, -1.0));
  const auto down = [&disc](double x, double y, double tNear = kNearest, double tFar = kFarthest) {
    return HitsOf(disc, { { x, y, 4.0 }, { 0.0, 0.0, -1.0 } }, tNear, tFar);
  };
  // The rim belongs to it.
  ASSERT_EQ(down(4.0, 6.0).size(), 1U);
  EXPECT_EQ(down(4.0, 6.0)[0].t, 1.0);
  EXPECT_EQ(down(4.0, 6.0)[0].position, Vec3(4.0, 6.0, 3.0));
  EXPECT_EQ(down(-4.0, 2.0).size(), 1U);
  EXPECT_TRUE(down(4.0, std::nextafter(6.0, 7.0)).empty());
  EXPECT_TRUE(down(std::nextafter(-4.0, -5.0), 2.0).empty());
  EXPECT_TRUE(down(5.0, 6.0).empty());
  // The same holds at the interval's ends.
  EXPECT_EQ(down(1.0, 2.0, 1.0, 1.0).size(), 1U);
  EXPECT_TRUE(down(1.0, 2.0, 1.5).empty());
  EXPECT_TRUE(down(1.0, 2.0, kNearest, 0.5).empty());
}

TEST(Disc, NoHitBehindAlongItOrFromIt)
{
  const Disc disc(Vec3(0.0), { 0.0, 0.0, 1.0 }, 1.0);
  const auto meets = [&disc](const Vec3& origin, const Vec3& direction) {
    return !HitsOf(disc, { origin, direction }).empty();
  };
  EXPECT_FALSE(meets({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }));
  EXPECT_FALSE(meets({ 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 }));
  EXPECT_FALSE(meets({ -2.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }));
  EXPECT_FALSE(meets({ 0.5, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }));
  EXPECT_TRUE(meets({ 0.5, 0.0, -1.0 }, { 0.0, 0.0, 1.0 }));
}

TEST(Disc, RefusesWhatIsNoDisc)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Vec3 up(0.0, 0.0, 1.0);
  const auto message = [](const Vec3& centre, const Vec3& normal, double radius)
  { return MessageOf([&] { Disc(centre, normal, radius); }); };
  EXPECT_EQ(message(Vec3(0.0), Vec3(0.0), 1.0), "disc: its normal is zero; give a direction.");
  EXPECT_EQ(message(Vec3(0.0), { 0.0, nan, 1.0 }, 1.0),
    "disc: a coordinate of its normal is not a finite number.");
  EXPECT_EQ(message({ 0.0, infinite, 0.0 }, up, 1.0),
    "disc: a coordinate of its position is not a finite number.");
  for (const double radius : { 0.0, -1.0, nan })
  {
    EXPECT_EQ(
      message(Vec3(0.0), up, radius), "disc: its radius is not positive; give one that is.");
  }
  EXPECT_EQ(message(Vec3(0.0), up, infinite),
    "disc: its radius is out of range; give one between 1e-100 and 1e100.");
  EXPECT_EQ(message(Vec3(0.0), 1e-300 * up, 1e-99), "");
}
} // namespace pixelexact::testing
