// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HitBatch.h"
#include "RootReference.h"

#include "Core/InstructionSets.h"
#include "Core/MeshBuilder.h"

#include "Core/Base/Error.h"
#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Hits of rays with surfaces, against their definitions in 113 bits.
namespace pixelexact::testing
{
inline void ExpectSameHits(const std::vector<Hit>& a, const std::vector<Hit>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    EXPECT_EQ(a[k].t, b[k].t);
    EXPECT_EQ(a[k].position, b[k].position);
    EXPECT_EQ(a[k].status, b[k].status);
  }
}

/// Counts of the checks, for the tests of the tests.
struct Tally
{
  int certain = 0;            ///< rays whose number of hits no small change of the inputs changes
  int uncertain = 0;          ///< the others
  int hits = 0;               ///< compared, one with one
  double tError = 0.0;        ///< largest error of t, in ulp(t) times its condition
  double plainError = 0.0;    ///< in ulp(t), where the condition is below 1e6
  double positionError = 0.0; ///< largest distance from ray's true point, in ulp of each coordinate
};

inline double UlpOf(double x)
{
  const double size = std::max(std::fabs(x), std::numeric_limits<double>::min());
  return std::nextafter(size, kNoHit) - size;
}

/// Compares the hits of a ray with those of the definition. Their number must be equal where a
/// change of 4 ulp in any input does not change it, and each must be within 4 ulp(t) times its
/// condition.
template <class Function>
void Compare(const Definition<Function>& truth, const Ray& ray, const Vec3& centre,
  const std::vector<Hit>& found, Tally& tally)
{
  constexpr double kChange = 4.0 * std::numeric_limits<double>::epsilon();
  // Any t0 will do; near the surface the polynomial's own rounding is small.
  Float128 t0 = 0;
  for (int d = 0; d < 3; ++d)
  {
    t0 += (static_cast<Float128>(centre[d]) - ray.origin[d]) * ray.direction[d];
  }
  const Polynomial p = truth.Along(ray, t0);
  const Polynomial slope = p.Derivative();
  const RealRoots real = RootsOf(p);
  bool certain = true;
  const auto check = [&](Float128 s)
  { certain = certain && Size(p.At(s)) > kChange * truth.Sensitivity(ray, t0 + s); };
  for (const Float128 s : real.critical)
  {
    check(s);
  }
  for (const Float128 s : RootsOf(slope).critical)
  {
    check(s);
  }
  // A vanishing leading coefficient moves a root to infinity.
  for (const Float128 s : real.roots)
  {
    const Float128 t = t0 + s;
    certain = certain &&
      Size(slope.At(s) * t) > kChange * (truth.Sensitivity(ray, t) + Size(slope.At(s) * t));
  }
  check(static_cast<Float128>(1e30));
  check(-static_cast<Float128>(1e30));
  std::vector<Float128> expected;
  for (const Float128 s : real.roots)
  {
    const Float128 t = t0 + s;
    const Float128 error = kChange * (truth.Sensitivity(ray, t) / Size(slope.At(s)) + Size(t));
    // Whether the first one is before the ray's origin.
    certain = certain && Size(t) > error;
    if (t > 0)
    {
      expected.push_back(t);
    }
  }
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    EXPECT_GE(found[k].t, k == 0 ? kNearest : found[k - 1].t);
  }
  if (!certain)
  {
    ++tally.uncertain;
    return;
  }
  ++tally.certain;
  ASSERT_EQ(found.size(), expected.size())
    << "of " << real.roots.size() << " roots, first "
    << (real.roots.empty() ? 0.0 : static_cast<double>(t0 + real.roots[0]));
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    ++tally.hits;
    EXPECT_EQ(found[k].status, HitStatus::Certain);
    const Float128 t = expected[k];
    const Float128 condition = 1 + truth.Sensitivity(ray, t) / Size(slope.At(t - t0) * t);
    const auto ulps = static_cast<double>(Size(found[k].t - t)) / UlpOf(static_cast<double>(t));
    tally.tError = std::max(tally.tError, ulps / static_cast<double>(condition));
    EXPECT_LE(ulps, 4.0 * static_cast<double>(condition));
    if (condition < 1e6)
    {
      tally.plainError = std::max(tally.plainError, ulps);
    }
    // The root's, not that of the rounded t. Its own condition is that of t.
    for (int d = 0; d < 3; ++d)
    {
      const Float128 x = ray.origin[d] + t * ray.direction[d];
      const double off =
        static_cast<double>(Size(found[k].position[d] - x)) / UlpOf(found[k].position[d]);
      const double allowed = 2.0 +
        truth.preparation * static_cast<double>(condition * Size(t)) / UlpOf(found[k].position[d]);
      EXPECT_LE(off, allowed);
      if (condition < 1e6)
      {
        tally.positionError = std::max(tally.positionError, off / allowed * 2.0);
      }
    }
  }
}

/// Rays of every kind around a point: from near and far, past it and through it.
class RaysAbout
{
public:
  explicit RaysAbout(std::uint64_t seed)
    : random_(seed)
  {
  }
  Random& Numbers() { return random_; }

  Vec3 Vector(double size) { return size * Vec3(random_(), random_(), random_()); }
  Vec3 UnitVector() { return ToDouble(Unit(ToLong(Vector(1.0) + Vec3(1e-3, 0.0, 0.0)))); }
  /// 10^least to 10^most, every decade alike.
  double Decades(double least, double most) { return std::pow(10.0, random_(least, most)); }
  double Sign() { return random_() < 0.0 ? -1.0 : 1.0; }

  /// A ray through a point, from a distance.
  Ray Through(const Vec3& x, double distance)
  {
    const double kind = random_();
    Vec3 along = UnitVector();
    if (kind < -0.7)
    {
      along = Vec3(0.0);
      along[static_cast<int>(random_(0.0, 3.0))] = Sign();
    }
    return { x - distance * along, along };
  }

  /// A ray through a point x of a surface, nearly in the tangent plane's direction, that passes x
  /// at a height above or below.
  Ray Grazing(const Vec3& x, const Vec3& normal, double height, double distance)
  {
    const LongVec3 inPlane = Cross(ToLong(normal), ToLong(Vector(1.0)));
    const Vec3 along = ToDouble(Unit(inPlane));
    return { x + height * normal - distance * along, along };
  }

private:
  Random random_;
};

/// Checks rays of one kind of surface: on the first instruction set against the definition, on the
/// others against the first.
class SurfaceCheck
{
public:
  explicit SurfaceCheck(int seed)
    : Seed(seed)
  {
  }

  /// check(random) on every instruction set, with the same random rays.
  template <class Check>
  void Run(const Check& check)
  {
    OnEveryInstructionSet(
      [&]
      {
        RaysAbout random(static_cast<std::uint64_t>(Seed));
        Next = 0;
        check(random);
        IsFirst = false;
      });
    const auto record = [](const char* what, double number)
    { ::testing::Test::RecordProperty(what, std::to_string(number)); };
    record("certain", Seen.certain);
    record("uncertain", Seen.uncertain);
    record("hits", Seen.hits);
    record("errorUlpTimesCondition", Seen.tError);
    record("errorUlp", Seen.plainError);
    record("positionUlp", Seen.positionError);
  }

  /// Adds rays, and others that graze the surface at their hits; all together and each alone.
  template <class Function>
  void Add(const Surface& surface, const Definition<Function>& truth, std::vector<Ray> rays,
    const Vec3& centre, double size, RaysAbout& random)
  {
    const auto found = MeetAll(surface, rays);
    AddRays(surface, truth, rays, found, centre);
    std::vector<Ray> grazing;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      if (!found[i].empty() && std::isfinite(found[i].back().t))
      {
        const SurfacePoint point{ found[i].back().position };
        const double height = i % 8 == 0 ? 0.0 : random.Sign() * size * random.Decades(-16.0, 0.0);
        grazing.push_back(random.Grazing(
          point.position, surface.Normal(point), height, size * random.Decades(-1.0, 1.0)));
      }
    }
    AddRays(surface, truth, grazing, MeetAll(surface, grazing), centre);
  }

  [[nodiscard]] const Tally& Result() const { return Seen; }

private:
  template <class Function>
  void AddRays(const Surface& surface, const Definition<Function>& truth,
    const std::vector<Ray>& rays, const std::vector<std::vector<Hit>>& found, const Vec3& centre)
  {
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      if (!IsFirst)
      {
        ASSERT_LT(Next, Kept.size());
        ExpectSameHits(found[i], Kept[Next++]);
        continue;
      }
      ExpectSameHits(found[i], HitsOf(surface, rays[i]));
      Compare(truth, rays[i], centre, found[i], Seen);
      Kept.push_back(found[i]);
    }
  }

  int Seed;
  bool IsFirst = true;
  std::vector<std::vector<Hit>> Kept;
  std::size_t Next = 0;
  Tally Seen;
};

/// Rays through, past and from within a round surface about a point.
inline std::vector<Ray> RoundRays(
  RaysAbout& random, const Vec3& centre, double radius, int count = 37)
{
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 normal = random.UnitVector();
    const Vec3 x = centre + radius * normal;
    const double far =
      radius * random.Decades(-1.0, 2.0) + (i % 4 == 0 ? random.Decades(0.0, 8.0) : 0.0);
    switch (i % 3)
    {
      case 0:
        rays.push_back(random.Through(centre + random.Vector(1.5 * radius), far));
        break;
      case 1:
        rays.push_back(
          random.Grazing(x, normal, random.Sign() * radius * random.Decades(-16.0, 0.0), far));
        break;
      default:
        // Rays from inside or from the surface itself.
        rays.push_back(
          { i % 2 == 0 ? x : centre + random.Vector(0.5 * radius), random.UnitVector() });
    }
  }
  return rays;
}

/// The message of the Error that make() throws.
template <class Make>
std::string MessageOf(const Make& make)
{
  try
  {
    make();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

/// The numbers of a Definition.
inline std::vector<double> Numbers(
  std::initializer_list<Vec3> vectors, const std::vector<double>& more)
{
  std::vector<double> numbers;
  for (const Vec3& x : vectors)
  {
    numbers.insert(numbers.end(), { x.x, x.y, x.z });
  }
  numbers.insert(numbers.end(), more.begin(), more.end());
  return numbers;
}
} // namespace pixelexact::testing
