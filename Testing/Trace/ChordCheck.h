// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HitBatch.h"
#include "MeshBuilder.h"

#include "Trace/Surfaces/Surface.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <vector>

// Distances of surfaces from chords, compared with hits of rays between and with signs in long
// double.
namespace pixelexact::testing
{
/// The distance of x from the segment.
inline double DistanceTo(const Vec3& from, const Vec3& to, const Vec3& x)
{
  const Vec3 along = to - from;
  const double s = std::clamp(glm::dot(x - from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(x, from + s * along);
}

/// The distance of the hit that is nearest to the segment.
inline double NearestHit(const Surface& surface, const Ray& ray, const Vec3& from, const Vec3& to)
{
  double nearest = kNoHit;
  for (const Hit& hit : HitsOf(surface, ray))
  {
    nearest = std::min(nearest, DistanceTo(from, to, hit.position));
  }
  return nearest;
}

/// Two rays of a camera, near to each other.
struct Pair
{
  Pair(Random& random, double away, double apart, bool parallel)
  {
    const Vec3 forward = glm::normalize(Vec3(random(), random(), random()));
    const Vec3 aside = glm::normalize(glm::cross(forward, Vec3(random(), random(), random())));
    const Vec3 target(0.9 * random(), 0.9 * random(), 0.9 * random());
    Eye = target - away * forward;
    Target = target;
    Step = apart * aside;
    IsParallel = parallel;
  }
  /// 0 and 1: the two; between them, those of the image between.
  [[nodiscard]] Ray At(double s) const
  {
    const Vec3 to = Target + s * Step;
    return IsParallel ? Ray{ Eye + s * Step, glm::normalize(Target - Eye) }
                      : Ray{ Eye, glm::normalize(to - Eye) };
  }

  Vec3 Eye;
  Vec3 Target;
  Vec3 Step;
  bool IsParallel;
};

/// The hit of a ray that is seen first.
inline std::optional<SurfacePoint> FirstHit(const Surface& surface, const Ray& ray)
{
  const auto hits = MeetPoints(surface, std::vector<Ray>{ ray }, std::vector{ kNearest }).front();
  return hits.empty() ? std::nullopt : std::optional(hits.front().point);
}

/// The place on a ray where it passes the line through two points.
inline long double PassingAt(
  const LongVec3& origin, const LongVec3& direction, const LongVec3& from, const LongVec3& along)
{
  // The nearest to the line: orthogonal to both.
  const LongVec3 normal = Cross(Cross(direction, along), along);
  return Dot(normal, Minus(from, origin)) / Dot(normal, direction);
}

/// Counts of checked chords.
struct ChordTally
{
  int chords = 0;
  int known = 0;
  int close = 0; ///< of short ones
  int closeKnown = 0;
  int tight = 0; ///< of short ones that are known: at most four times what it is

  void Tell(const char* name) const
  {
    std::cout << name << ": " << known << " known of " << chords << ", of short ones " << closeKnown
              << " of " << close << ", tight " << tight << '\n';
  }
};

/// The function is negative inside a body.
using LongSide = std::function<long double(const LongVec3& x)>;

/// The distance from the chord of the nearest intersection of a ray with the body's boundary, up to
/// `most`; infinite where there is none.
inline long double NearestChange(
  const std::function<long double(long double off)>& side, long double most)
{
  constexpr int kSamples = 16;
  constexpr int kSteps = 24;
  const bool inside = side(0) < 0;
  for (int k = 1; k <= kSamples; ++k)
  {
    for (const int sign : { -1, 1 })
    {
      long double ends[2] = { sign * most * (k - 1) / kSamples, sign * most * k / kSamples };
      if ((side(ends[1]) < 0) != inside)
      {
        for (int step = 0; step < kSteps; ++step)
        {
          const long double middle = (ends[0] + ends[1]) / 2;
          ends[(side(middle) < 0) == inside ? 0 : 1] = middle;
        }
        return std::fabs(ends[1]);
      }
    }
  }
  return std::numeric_limits<long double>::infinity();
}

/// Between rays' first hits of a body: where there is a bound, `side` changes its sign along each
/// ray between within the bound of the chord. Chords are between a millionth and a tenth long.
inline ChordTally CheckChords(
  const Surface& surface, const LongSide& side, unsigned seed, int count = 3000)
{
  Random random(seed);
  ChordTally tally;
  for (int k = 0; k < count; ++k)
  {
    const double apart = std::pow(10.0, random(-6.0, -1.0));
    const double away = std::pow(10.0, random(0.5, k % 4 == 0 ? 5.0 : 1.5));
    const Pair pair(random, away, apart, k % 2 == 0);
    const auto from = FirstHit(surface, pair.At(0.0));
    const auto to = FirstHit(surface, pair.At(1.0));
    if (!from || !to)
    {
      continue;
    }
    const double sagitta = surface.Sagitta(pair.At(0.0), *from, pair.At(1.0), *to);
    const bool isClose = apart < 1e-3;
    ++tally.chords;
    tally.close += isClose ? 1 : 0;
    if (!std::isfinite(sagitta))
    {
      continue;
    }
    ++tally.known;
    tally.closeKnown += isClose ? 1 : 0;
    // Rounding of rays: some units in the last place of the distance.
    const long double slack = 4e-15L * static_cast<long double>(away);
    const LongVec3 start = ToLong(from->position);
    const LongVec3 along = Minus(ToLong(to->position), start);
    long double farthest = 0;
    for (int i = 1; i < 16; ++i)
    {
      const Ray ray = pair.At(i / 16.0);
      const LongVec3 origin = ToLong(ray.origin);
      const LongVec3 direction = Unit(ToLong(ray.direction));
      const long double t = PassingAt(origin, direction, start, along);
      farthest = std::max(farthest,
        NearestChange([&](long double off)
          { return side(Plus(origin, Times(t + off, direction))); },
          sagitta + slack));
    }
    EXPECT_TRUE(std::isfinite(farthest)) << "apart " << apart << ", away " << away;
    tally.tight += isClose && sagitta <= 4.0L * farthest + 64.0L * slack ? 1 : 0;
  }
  return tally;
}
} // namespace pixelexact::testing
