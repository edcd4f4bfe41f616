// SPDX-License-Identifier: BSD-3-Clause
#include "InstructionSets.h"
#include "RayCheck.h"

#include "Trace/Surfaces/Plane.h"

#include "Core/Base/Error.h"

#include <limits>

namespace pixelexact::testing
{
namespace
{
void CheckRandomPlanes()
{
  RandomRays random(61);
  int certain = 0;
  int uncertain = 0;
  int none = 0;
  for (int k = 0; k < 300; ++k)
  {
    const Vec3 through = random.Vector(random.Size(-3.0, 6.0));
    const Vec3 normal =
      random.Vector(random.Size(-200.0, 200.0)) * Vec3(1.0, random.Size(-6.0, 0.0), 1.0);
    const Plane plane(through, normal);
    const LongPlane truth(ToLong(through), ToLong(normal));
    EXPECT_LE(Largest(Minus(ToLong(plane.Normal({})), truth.normal)), 4.0 * kUnitRoundoff);
    // More than one pack, and a part of one.
    std::vector<Ray> rays;
    std::vector<TrueHit> hits;
    std::vector<double> tNear;
    for (int i = 0; i < 53; ++i)
    {
      rays.push_back(random.Near(through, normal));
      hits.push_back(truth.Meet(rays.back()));
      tNear.push_back(std::max(kNearest, random.Start(hits.back().t)));
    }
    const auto found = AllHits(plane, rays, tNear);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const int expected = ExpectHits(found[i], { hits[i] }, tNear[i]);
      certain += expected;
      uncertain += hits[i].certain ? 0 : 1;
      none += found[i].empty() ? 1 : 0;
      for (const auto& [t, position, status] : found[i])
      {
        const LongVec3 x = ToLong(position);
        const LongVec3 at = Plus(ToLong(rays[i].origin), Times(t, ToLong(rays[i].direction)));
        EXPECT_LE(Largest(Minus(x, at)), RayError(rays[i], t, truth.origin));
        EXPECT_LE(truth.Distance(x), truth.DistanceError(x));
      }
    }
  }
  // Some of each kind.
  EXPECT_GT(certain, 4500);
  EXPECT_GT(uncertain, 300);
  EXPECT_GT(none, 3000);
}
} // namespace

TEST(Plane, HitsAreOnRayAndPlaneAndNoneIsMissing)
{
  OnEveryInstructionSet(CheckRandomPlanes);
}

TEST(Plane, NoHitBehindParallelOrBeyondTheInterval)
{
  const Plane plane(Vec3(0.0), { 0.0, 0.0, 1.0 });
  const auto meets = [&plane](const Ray& ray, double tNear = kNearest, double tFar = kFarthest)
  { return HitsOf(plane, ray, tNear, tFar).size(); };
  EXPECT_EQ(meets({ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } }), 0U);
  EXPECT_EQ(meets({ { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } }), 0U);
  EXPECT_EQ(meets({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }), 0U);
  // A ray that starts on the plane.
  EXPECT_EQ(meets({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } }), 0U);
  const Ray down{ { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  EXPECT_EQ(meets(down, 1.5), 0U);
  EXPECT_EQ(meets(down, 0.0, 0.5), 0U);
  EXPECT_EQ(meets(down, 2.0, 0.5), 0U);
  // The interval's ends belong to it.
  EXPECT_EQ(meets(down, 1.0), 1U);
  EXPECT_EQ(meets(down, 0.5, 1.0), 1U);
  EXPECT_EQ(HitsOf(plane, down).at(0).t, 1.0);
}

TEST(Plane, RefusesWhatIsNoPlane)
{
  EXPECT_THROW(Plane(Vec3(0.0), Vec3(0.0)), Error);
  EXPECT_THROW(Plane(Vec3(0.0), Vec3(0.0, std::nan(""), 1.0)), Error);
  EXPECT_THROW(Plane(Vec3(std::numeric_limits<double>::infinity()), Vec3(1.0)), Error);
  EXPECT_NO_THROW(Plane(Vec3(0.0), Vec3(0.0, 1e-300, 0.0)));
}
} // namespace pixelexact::testing
