// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/MeshBuilder.h"
#include "Trace/HitBatch.h"

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Compares hits of rays with surfaces that consist of planes with closed forms in long double.
namespace pixelexact::testing
{
/// The true intersection of a ray with a surface.
struct TrueHit
{
  long double t;
  LongVec3 position;
  long double error; ///< how far rounding may move t
  bool certain;      ///< whatever the rounding
};

/// The points x with normal . (x - origin) = 0.
struct LongPlane
{
  LongVec3 origin;
  LongVec3 normal;              ///< of unit length
  long double roundings = 8.0L; ///< of the numbers of a Plane and of its sums and products, in u
  long double offset = 0.0L;    ///< how far off a Plane's origin may be

  LongPlane(const LongVec3& through, const LongVec3& across)
    : origin(through)
    , normal(Unit(across))
  {
  }

  /// For a ray whose slope rounding may make zero or of either sign, any hit or none is accepted.
  [[nodiscard]] TrueHit Meet(const Ray& ray) const
  {
    const LongVec3 direction = ToLong(ray.direction);
    const LongVec3 distance = Minus(origin, ToLong(ray.origin));
    const long double u = roundings * kUnitRoundoff;
    const long double slope = Dot(normal, direction);
    const long double slopeError = u * Dot(Absolute(normal), Absolute(direction));
    const long double t = Dot(normal, distance) / slope;
    TrueHit hit{ t, Plus(ToLong(ray.origin), Times(t, direction)),
      std::numeric_limits<long double>::infinity(), false };
    if (std::fabs(slope) > slopeError)
    {
      hit.error =
        (u * Dot(Absolute(normal), Absolute(distance)) + offset + std::fabs(t) * slopeError) /
          (std::fabs(slope) - slopeError) +
        kUnitRoundoff * std::fabs(t);
      hit.certain = true;
    }
    return hit;
  }

  [[nodiscard]] long double Distance(const LongVec3& x) const
  {
    return std::fabs(Dot(normal, Minus(x, origin)));
  }

  /// A bound of a position's distance from the plane, from the rounding of its coordinates and of
  /// the normal's product with its distance from the plane's origin, not from that of t.
  [[nodiscard]] long double DistanceError(const LongVec3& x) const
  {
    return offset + roundings * kUnitRoundoff * Dot(Absolute(normal), Absolute(Minus(x, origin))) +
      2.0L * kUnitRoundoff * Dot(Absolute(normal), Absolute(x));
  }
};

/// A bound of the distance of a position on the surface from the ray's point at t, from the
/// rounding of all sums of coordinates. It also bounds the distance of that point from the surface.
inline long double RayError(const Ray& ray, long double t, const LongVec3& origin)
{
  constexpr long double kRoundings = 24.0L;
  const LongVec3 ones{ 1.0L, 1.0L, 1.0L };
  return kRoundings * kUnitRoundoff *
    (Dot(ones, Absolute(ToLong(ray.origin))) + Dot(ones, Absolute(origin)) +
      std::fabs(t) * Dot(ones, Absolute(ToLong(ray.direction))));
}

/// All hits of each ray beyond its tNear; one ray alone and many at once have the same.
inline std::vector<std::vector<Hit>> AllHits(
  const Surface& surface, const std::vector<Ray>& rays, const std::vector<double>& tNear)
{
  std::vector<std::vector<Hit>> all = MeetAll(surface, rays, tNear);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    for (const Hit& hit : all[i])
    {
      EXPECT_GE(hit.t, tNear[i]);
    }
    const std::vector<Hit> alone = HitsOf(surface, rays[i], tNear[i]);
    EXPECT_EQ(alone.size(), all[i].size());
    for (std::size_t k = 0; k < std::min(alone.size(), all[i].size()); ++k)
    {
      EXPECT_EQ(alone[k].t, all[i][k].t);
      EXPECT_EQ(alone[k].position, all[i][k].position);
    }
  }
  return all;
}

/// Each hit found is one of the true ones, and every certain one from tNear on is found, but those
/// that rounding may put on tNear's other side. Returns how many hits were certain.
inline int ExpectHits(
  const std::vector<Hit>& found, const std::vector<TrueHit>& expected, double tNear)
{
  std::vector<bool> taken(expected.size(), false);
  for (const Hit& hit : found)
  {
    bool known = false;
    // Certain ones first: the others fit nearly everywhere.
    for (const bool certain : { true, false })
    {
      for (std::size_t k = 0; k < expected.size() && !known; ++k)
      {
        if (!taken[k] && expected[k].certain == certain &&
          std::fabs(expected[k].t - hit.t) <= expected[k].error)
        {
          known = true;
          taken[k] = true;
        }
      }
    }
    EXPECT_TRUE(known) << "at " << hit.t << " is no hit";
  }
  int certain = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    const auto& [t, position, error, always] = expected[k];
    if (always && t - error > tNear)
    {
      ++certain;
      EXPECT_TRUE(taken[k]) << "the hit at " << static_cast<double>(t) << " is missing";
    }
  }
  return certain;
}

/// A plane and rays that meet it, miss it, or nearly touch it, of sizes and distances over many
/// decades.
class RandomRays
{
public:
  explicit RandomRays(std::uint64_t seed)
    : random_(seed)
  {
  }

  Vec3 Vector(double size) { return size * Vec3(random_(), random_(), random_()); }
  /// 10^least to 10^most, every decade alike.
  double Size(double least, double most) { return std::pow(10.0, random_(least, most)); }

  /// A ray from anywhere in any direction, or nearly along a plane with that normal.
  Ray Near(const Vec3& through, const Vec3& normal)
  {
    const Vec3 origin = through + Vector(Size(-2.0, 8.0));
    Vec3 along = Vector(1.0);
    if (random_() < 0.0)
    {
      const Vec3 unit = ToDouble(Unit(ToLong(normal)));
      const LongVec3 inPlane = Cross(ToLong(unit), ToLong(along));
      along = ToDouble(inPlane) + (random_() < 0.0 ? -1.0 : 1.0) * Size(-20.0, 0.0) * unit;
    }
    return { origin, ToDouble(Unit(ToLong(along))) };
  }

  /// Before the ray's origin, at it, or near the hit, on either side.
  double Start(long double t)
  {
    const double kind = random_();
    if (kind < 0.0 || !std::isfinite(static_cast<double>(t)))
    {
      return 0.0;
    }
    return static_cast<double>(t) * (1.0 + (kind < 0.5 ? -1.0 : 1.0) * Size(-16.0, 0.0));
  }

private:
  Random random_;
};
} // namespace pixelexact::testing
