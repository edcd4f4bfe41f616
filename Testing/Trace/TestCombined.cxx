// SPDX-License-Identifier: BSD-3-Clause
#include "RayCheck.h"
#include "Solids.h"
#include "SurfaceCheck.h"

#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Quadric.h"

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
bool All(const std::vector<bool>& inside)
{
  return std::ranges::all_of(inside, [](bool in) { return in; });
}
bool Any(const std::vector<bool>& inside)
{
  return std::ranges::any_of(inside, [](bool in) { return in; });
}
bool FirstAlone(const std::vector<bool>& inside)
{
  return inside[0] && std::none_of(inside.begin() + 1, inside.end(), [](bool in) { return in; });
}

/// Against the parts' own hits: one counts where the whole is another on its two sides, a millionth
/// away; rays with two hits closer than that are left out.
void CheckCombined(const std::vector<Combined::Part>& parts, const Combined::Rule& rule)
{
  const Combined whole(parts, rule);
  RandomRays random(4);
  constexpr double kAside = 1e-6;
  int counted = 0;
  int none = 0;
  for (int k = 0; k < 4000; ++k)
  {
    const Vec3 origin = random.Vector(3.0);
    const Ray ray{ origin, glm::normalize(random.Vector(1.0) - origin) };
    std::vector<Hit> all;
    for (const Combined::Part& part : parts)
    {
      const auto own = HitsOf(*part.surface, ray);
      all.insert(all.end(), own.begin(), own.end());
    }
    std::ranges::sort(all, {}, &Hit::t);
    const auto close = [](const Hit& a, const Hit& b) { return b.t - a.t < 4.0 * kAside; };
    if (std::ranges::adjacent_find(all, close) != all.end() ||
      (!all.empty() && all[0].t < 2.0 * kAside))
    {
      continue;
    }
    const auto inside = [&](double t)
    {
      std::vector<bool> in;
      for (const Combined::Part& part : parts)
      {
        in.push_back(part.side(ray.origin + t * ray.direction) < 0.0);
      }
      return rule(in);
    };
    std::erase_if(
      all, [&](const Hit& hit) { return inside(hit.t - kAside) == inside(hit.t + kAside); });
    const auto found = HitsOf(whole, ray);
    ExpectSameHits(found, all);
    counted += static_cast<int>(found.size());
    none += found.empty() ? 1 : 0;
  }
  EXPECT_GT(counted, 300);
  EXPECT_GT(none, 100);
}
} // namespace

TEST(Combined, UnionsIntersectionsDifferences)
{
  const std::vector<Combined::Part> parts{ MakeCubePart(0.8), MakeBallPart({ 0.5, 0.2, 0.1 }, 0.9),
    MakeBallPart({ -0.6, 0.4, -0.3 }, 0.5) };
  CheckCombined(parts, All);
  CheckCombined(parts, Any);
  CheckCombined(parts, FirstAlone);
}

TEST(Combined, PartsThatTouchOrLieOnEachOther)
{
  const Ray ray{ Vec3(-3.0, 0.0, 0.0), { 1.0, 0.0, 0.0 } };
  // Two balls that touch at 0: in, out and in at once, out.
  const Combined touching(
    { MakeBallPart({ -1.0, 0.0, 0.0 }, 1.0), MakeBallPart({ 1.0, 0.0, 0.0 }, 1.0) }, Any);
  EXPECT_EQ(HitsOf(touching, ray).size(), 2U);
  // The same ball twice.
  const std::vector<Combined::Part> twice{ MakeBallPart(Vec3(0.0), 1.0),
    MakeBallPart(Vec3(0.0), 1.0) };
  EXPECT_EQ(HitsOf(Combined(twice, Any), ray).size(), 2U);
  EXPECT_EQ(HitsOf(Combined(twice, All), ray).size(), 2U);
  EXPECT_EQ(HitsOf(Combined(twice, FirstAlone), ray).size(), 0U);
  // A ray that touches.
  EXPECT_EQ(HitsOf(Combined(twice, Any), { Vec3(-3.0, 1.0, 0.0), ray.direction }).size(), 0U);
}

TEST(Combined, IntervalsBeginAndEndAnywhere)
{
  const Combined shell({ MakeBallPart(Vec3(0.0), 2.0), MakeBallPart(Vec3(0.0), 1.0) }, FirstAlone);
  const Ray ray{ Vec3(-3.0, 0.0, 0.0), { 1.0, 0.0, 0.0 } };
  const auto times = [&](double tNear, double tFar)
  {
    std::vector<double> t;
    for (const Hit& hit : HitsOf(shell, ray, tNear, tFar))
    {
      t.push_back(hit.t);
    }
    return t;
  };
  using List = std::vector<double>;
  EXPECT_EQ(times(kNearest, kFarthest), (List{ 1.0, 2.0, 4.0, 5.0 }));
  EXPECT_EQ(times(1.5, 4.5), (List{ 2.0, 4.0 }));
  EXPECT_EQ(times(2.5, 3.5), (List{}));
  EXPECT_EQ(times(4.5, kFarthest), (List{ 5.0 }));
}

TEST(Combined, NormalsAreTheParts)
{
  const Combined whole({ MakeCubePart(1.0), MakeBallPart({ 1.0, 0.0, 0.0 }, 0.5) }, FirstAlone);
  HitSlots hits;
  const auto normalAt = [&](const Ray& ray)
  {
    const auto found = HitsOf(whole, ray);
    SurfacePoint point;
    EXPECT_EQ(found.size(), 2U);
    hits.Begin(1);
    const double lanes[8] = { ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
      ray.direction.y, ray.direction.z, kNearest, kFarthest };
    std::vector<std::vector<double>> padded;
    for (const double number : lanes)
    {
      padded.emplace_back(static_cast<std::size_t>(PaddedCount(1)), number);
    }
    whole.Meet({ { padded[0].data(), padded[1].data(), padded[2].data() },
                 { padded[3].data(), padded[4].data(), padded[5].data() }, padded[6].data(),
                 padded[7].data(), 1 },
      hits);
    return whole.Normal(hits.PointOf(0, 0));
  };
  // Into the hollow, and onto a face of the cube.
  const Vec3 hollow = normalAt({ Vec3(3.0, 0.0, 0.0), { -1.0, 0.0, 0.0 } });
  EXPECT_EQ(glm::abs(hollow), Vec3(1.0, 0.0, 0.0));
  const Vec3 face = normalAt({ Vec3(0.2, 3.0, 0.3), { 0.0, -1.0, 0.0 } });
  EXPECT_EQ(glm::abs(face), Vec3(0.0, 1.0, 0.0));
}

TEST(Combined, NonsenseIsRefused)
{
  EXPECT_NE(MessageOf([] { Combined({}, Any); }).find("no parts"), std::string::npos);
}
} // namespace pixelexact::testing
