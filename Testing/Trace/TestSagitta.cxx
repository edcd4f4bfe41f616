// SPDX-License-Identifier: BSD-3-Clause
// How far quadrics are off chords, against the hits of rays between.
#include "ChordCheck.h"

#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
struct QuadricCase
{
  const char* name;
  Quadric surface;
};

std::vector<QuadricCase> AllQuadrics()
{
  const Vec3 axis(0.6, 0.3, 0.74);
  return { { "sphere", MakeSphere(Vec3(0.1, -0.2, 0.3), 0.7) },
    { "cylinder", MakeCylinder(Vec3(0.1, 0.0, 0.0), axis, 0.5) },
    { "cone", MakeCone(Vec3(0.1, 0.0, 0.0), axis, 25.0) },
    { "hyperboloid", MakeQuadric({ 1.0, 1.5, -0.8, 0.0, 0.1, 0.0, 0.1, 0.0, 0.0, -0.3 }) },
    { "ellipsoid", MakeQuadric({ 1.0, 4.0, 9.0, 0.2, 0.0, 0.1, 0.1, 0.0, 0.0, -1.0 }) },
    { "paraboloid", MakeQuadric({ 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 }) } };
}
} // namespace

/// Pairs of rays from near and far, a millionth to a tenth apart.
TEST(Sagitta, HoldsHitsBetween)
{
  Random random(81);
  for (const QuadricCase& one : AllQuadrics())
  {
    SCOPED_TRACE(one.name);
    int known = 0;
    int close = 0;
    int closeKnown = 0;
    int tight = 0;
    for (int k = 0; k < 3000; ++k)
    {
      const double apart = std::pow(10.0, random(-6.0, -1.0));
      const double away = std::pow(10.0, random(0.3, k % 4 == 0 ? 5.0 : 1.5));
      const Pair pair(random, away, apart, k % 2 == 0);
      const Ray a = pair.At(0.0);
      const Ray b = pair.At(1.0);
      const auto hitsA = HitsOf(one.surface, a);
      const auto hitsB = HitsOf(one.surface, b);
      if (hitsA.empty() || hitsA.size() != hitsB.size())
      {
        continue;
      }
      const Vec3 from = hitsA.front().position;
      const Vec3 to = hitsB.front().position;
      const double sagitta = one.surface.Sagitta(a, { from }, b, { to });
      const bool isClose = apart < 1e-3;
      close += isClose ? 1 : 0;
      closeKnown += isClose && std::isfinite(sagitta) ? 1 : 0;
      if (!std::isfinite(sagitta))
      {
        continue;
      }
      ++known;
      double farthest = 0.0;
      for (int i = 1; i < 16; ++i)
      {
        farthest = std::max(farthest, NearestHit(one.surface, pair.At(i / 16.0), from, to));
      }
      EXPECT_LE(farthest, sagitta + 1e-15 * away) << "apart " << apart << ", away " << away;
      tight += sagitta <= 8.0 * farthest + 1e-12 * away ? 1 : 0;
    }
    std::cout << one.name << ": " << known << " known, of close ones " << closeKnown << " of "
              << close << ", tight " << tight << '\n';
    EXPECT_GT(known, 400);
    EXPECT_GT(closeKnown, 0.9 * close);
    EXPECT_GT(tight, 0.8 * known);
  }
}

/// Triangles of rays about as far apart, and rays between them.
TEST(Sagitta, HoldsHitsOverTriangles)
{
  Random random(82);
  for (const QuadricCase& one : AllQuadrics())
  {
    SCOPED_TRACE(one.name);
    int known = 0;
    for (int k = 0; k < 2000; ++k)
    {
      const double apart = std::pow(10.0, random(-6.0, -1.0));
      Pair pair(random, std::pow(10.0, random(0.3, 1.5)), apart, k % 2 == 0);
      const Vec3 aside = pair.Step;
      const Vec3 up =
        apart * glm::normalize(glm::cross(pair.Target - pair.Eye, aside) + random() * aside);
      const auto rayAt = [&](double s, double t)
      {
        pair.Step = s * aside + t * up;
        return pair.At(1.0);
      };
      const std::array<Ray, 3> rays{ rayAt(0.0, 0.0), rayAt(1.0, 0.0), rayAt(0.0, 1.0) };
      std::array<Vec3, 3> corners;
      bool all = true;
      const std::size_t count = HitsOf(one.surface, rays[0]).size();
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const auto hits = HitsOf(one.surface, rays[i]);
        all = all && !hits.empty() && hits.size() == count;
        corners[i] = hits.empty() ? Vec3(0.0) : hits.front().position;
      }
      const double sagitta =
        all ? one.surface.SagittaOver(rays, corners) : std::numeric_limits<double>::infinity();
      if (!std::isfinite(sagitta))
      {
        continue;
      }
      ++known;
      const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      for (int i = 0; i < 8; ++i)
      {
        const double s = random(0.0, 1.0);
        const Ray ray = rayAt(s, random(0.0, 1.0 - s));
        const double t =
          glm::dot(corners[0] - ray.origin, normal) / glm::dot(ray.direction, normal);
        const Vec3 at = ray.origin + t * ray.direction;
        double nearest = kNoHit;
        for (const Hit& hit : HitsOf(one.surface, ray))
        {
          nearest = std::min(nearest, glm::distance(hit.position, at));
        }
        EXPECT_LE(nearest, sagitta + 1e-9 * apart) << "apart " << apart;
      }
    }
    EXPECT_GT(known, 200);
  }
}

/// Between front and back, and where one ray misses, there is no bound.
TEST(Sagitta, IsInfiniteAcrossSilhouettes)
{
  const Quadric sphere = MakeSphere(Vec3(0.0), 1.0);
  const Vec3 along(0.0, 0.0, -1.0);
  for (const double beside : { 1e-12, 1e-6, 1e-3, 0.1 })
  {
    const Ray ray{ Vec3(1.0 - beside, 0.0, 5.0), along };
    const auto hits = HitsOf(sphere, ray);
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_FALSE(
      std::isfinite(sphere.Sagitta(ray, { hits[0].position }, ray, { hits[1].position })));
  }
  for (const double apart : { 0.2, 1e-2, 1e-5 })
  {
    // Both on the front, the one at the silhouette.
    const Ray a{ Vec3(1.0 - apart, 0.0, 5.0), along };
    const Ray b{ Vec3(1.0, 0.0, 5.0), along };
    const Vec3 at = HitsOf(sphere, a).front().position;
    EXPECT_FALSE(std::isfinite(sphere.Sagitta(a, { at }, b, { Vec3(1.0, 0.0, 0.0) })));
  }
  const Quadric cylinder = MakeCylinder(Vec3(0.0), Vec3(0.0, 1.0, 0.0), 1.0);
  const Ray left{ Vec3(-0.999, 0.0, 5.0), along };
  const Ray right{ Vec3(0.999, 0.5, 5.0), along };
  EXPECT_FALSE(std::isfinite(cylinder.Sagitta(left, { HitsOf(cylinder, left).front().position },
    right, { HitsOf(cylinder, right).front().position })));
}

TEST(Sagitta, OfPlanes)
{
  const Ray ray{ Vec3(0.0, 0.0, 5.0), Vec3(0.0, 0.0, -1.0) };
  const Plane plane(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
  EXPECT_TRUE(plane.HasSagitta());
  EXPECT_EQ(plane.Sagitta(ray, { Vec3(0.0) }, ray, { Vec3(0.0) }), 0.0);
}
} // namespace pixelexact::testing
