// SPDX-License-Identifier: BSD-3-Clause
// How far tori, convex bodies and booleans are off chords.
#include "ChordCheck.h"

#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include <limits>
#include <memory>
#include <vector>

namespace pixelexact::testing
{
namespace
{
LongSide TorusSide(const Vec3& centre, const Vec3& axis, double R, double r)
{
  return [=](const LongVec3& x)
  {
    const LongVec3 y = Minus(x, ToLong(centre));
    const LongVec3 a = Unit(ToLong(axis));
    const long double z = Dot(a, y);
    const LongVec3 across = Minus(y, Times(z, a));
    const long double rho = std::sqrt(Dot(across, across));
    const long double near = (rho - R) * (rho - R) + z * z - static_cast<long double>(r) * r;
    const long double far = (rho + R) * (rho + R) + z * z - static_cast<long double>(r) * r;
    return near * far;
  };
}

LongSide SphereSide(const Vec3& centre, double radius)
{
  return [=](const LongVec3& x)
  {
    const LongVec3 y = Minus(x, ToLong(centre));
    return Dot(y, y) - static_cast<long double>(radius) * radius;
  };
}

LongSide HalfSpacesSide(const std::vector<HalfSpace>& all)
{
  return [=](const LongVec3& x)
  {
    long double largest = -1e30L;
    for (const HalfSpace& one : all)
    {
      largest = std::max(largest, Dot(Unit(ToLong(one.normal)), Minus(x, ToLong(one.point))));
    }
    return largest;
  };
}

std::vector<HalfSpace> BoxSides(double half)
{
  std::vector<HalfSpace> sides;
  for (int d = 0; d < 3; ++d)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      Vec3 normal(0.0);
      normal[d] = sign;
      sides.push_back({ half * normal, normal });
    }
  }
  return sides;
}

Combined::Part PartOf(std::shared_ptr<const Surface> surface, const LongSide& side)
{
  return { std::move(surface),
    [side](const Vec3& x) { return static_cast<double>(side(ToLong(x))); } };
}
} // namespace

TEST(SagittaOfTori, HoldsSignsInLongDouble)
{
  struct Case
  {
    const char* name;
    double R;
    double r;
    int known;
  };
  // The last one passes through itself.
  for (const Case& one : { Case{ "torus", 0.6, 0.25, 600 }, Case{ "thin torus", 0.7, 0.02, 20 },
         Case{ "thick torus", 0.5, 0.49, 600 }, Case{ "lemon", 0.3, 0.6, 600 } })
  {
    SCOPED_TRACE(one.name);
    const Vec3 centre(0.05, -0.1, 0.02);
    const Vec3 axis(0.3, 0.2, 0.9);
    const Torus torus(centre, axis, one.R, one.r);
    EXPECT_TRUE(torus.HasSagitta());
    const ChordTally tally = CheckChords(torus, TorusSide(centre, axis, one.R, one.r), 5);
    tally.Tell(one.name);
    EXPECT_GT(tally.known, one.known);
    EXPECT_GT(tally.closeKnown, 0.9 * tally.close);
    EXPECT_GT(tally.tight, 0.95 * tally.closeKnown);
  }
}

/// Tori of any size and position.
TEST(SagittaOfTori, IsTheSameInOtherUnits)
{
  for (const double unit : { 1e-30, 1e-6, 1e6, 1e30 })
  {
    const Torus small(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 0.6, 0.25);
    const Torus scaled(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 0.6 * unit, 0.25 * unit);
    const auto sagitta = [](const Torus& torus, double size)
    {
      const Vec3 along(0.0, 0.6, -0.8);
      const Ray a{ size * Vec3(0.5, -3.0, 4.0), along };
      const Ray b{ size * Vec3(0.501, -3.0, 4.0), along };
      return torus.Sagitta(a, FirstHit(torus, a).value(), b, FirstHit(torus, b).value());
    };
    EXPECT_NEAR(sagitta(scaled, unit) / unit, sagitta(small, 1.0), 1e-10);
    EXPECT_LT(sagitta(small, 1.0), 2e-6);
  }
}

/// Nothing is known between the front and the back, across a silhouette, or through the hole.
TEST(SagittaOfTori, IsInfiniteAcrossSilhouettes)
{
  const Torus torus(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 0.6, 0.25);
  const Vec3 along(0.0, 0.0, -1.0);
  for (const double beside : { 1e-12, 1e-6, 1e-3, 0.1 })
  {
    const Ray ray{ Vec3(0.85 - beside, 0.0, 5.0), along };
    const auto hits = HitsOf(torus, ray);
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_FALSE(
      std::isfinite(torus.Sagitta(ray, { hits[0].position }, ray, { hits[1].position })));
    // Both on the front, one at the silhouette.
    const Ray rim{ Vec3(0.85, 0.0, 5.0), along };
    EXPECT_FALSE(
      std::isfinite(torus.Sagitta(ray, { hits[0].position }, rim, { Vec3(0.85, 0.0, 0.0) })));
  }
  const Ray left{ Vec3(-0.4, 0.0, 5.0), along };
  const Ray right{ Vec3(0.4, 0.0, 5.0), along };
  EXPECT_FALSE(std::isfinite(
    torus.Sagitta(left, FirstHit(torus, left).value(), right, FirstHit(torus, right).value())));
  // The apexes of a lemon.
  const Torus lemon(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 0.3, 0.5);
  const Ray a{ Vec3(-1e-4, 1e-5, 5.0), along };
  const Ray b{ Vec3(1e-4, 1e-5, 5.0), along };
  const auto inner = [&](const Ray& ray) { return HitsOf(lemon, ray).at(1).position; };
  EXPECT_FALSE(std::isfinite(lemon.Sagitta(a, { inner(a) }, b, { inner(b) })));
}

TEST(SagittaOfConvexBodies, HoldsSignsInLongDouble)
{
  const ConvexBody box = MakeBox(Vec3(-0.7), Vec3(0.7));
  EXPECT_TRUE(box.HasSagitta());
  const ChordTally ofBox = CheckChords(box, HalfSpacesSide(BoxSides(0.7)), 11);
  ofBox.Tell("box");
  EXPECT_GT(ofBox.closeKnown, 0.95 * ofBox.close);
  EXPECT_GT(ofBox.tight, 0.95 * ofBox.closeKnown);
  // A body of 60 planes about a ball: nearly all chords cross creases.
  Random random(12);
  std::vector<HalfSpace> all;
  for (int k = 0; k < 60; ++k)
  {
    const Vec3 normal = glm::normalize(Vec3(random(), random(), random()));
    all.push_back({ 0.7 * normal, normal });
  }
  const ConvexBody cut(all);
  const ChordTally ofCut = CheckChords(cut, HalfSpacesSide(all), 13);
  ofCut.Tell("60 planes");
  EXPECT_GT(ofCut.closeKnown, 0.95 * ofCut.close);
  EXPECT_GT(ofCut.tight, 0.95 * ofCut.closeKnown);
}

/// The crease of two faces that rise as steeply: in the middle it is half the chord high.
TEST(SagittaOfConvexBodies, OfACrease)
{
  const ConvexBody roof(
    { { Vec3(0.0), Vec3(-0.6, 0.0, 0.8) }, { Vec3(0.0), Vec3(0.6, 0.0, 0.8) } });
  const Vec3 down(0.0, 0.0, -1.0);
  const Ray a{ Vec3(-0.01, 0.0, 3.0), down };
  const Ray b{ Vec3(0.01, 0.0, 3.0), down };
  const double sagitta = roof.Sagitta(a, *FirstHit(roof, a), b, *FirstHit(roof, b));
  // 0.01 times the slope 0.6 / 0.8: the distance 0.006 across a face, divided by 0.8.
  EXPECT_NEAR(sagitta, 0.0075, 1e-9);
  // From a side on which one of the faces is hidden there is no bound.
  const Vec3 aside = glm::normalize(Vec3(1.0, 0.0, -0.5));
  const Ray c{ Vec3(-1.0, 0.0, 0.45), aside };
  const Ray d{ Vec3(-1.0, 0.0, 0.5001), aside };
  const auto from = FirstHit(roof, c);
  const auto to = FirstHit(roof, d);
  EXPECT_TRUE(!from || !to || !std::isfinite(roof.Sagitta(c, *from, d, *to)));
}

TEST(SagittaOfBooleans, HoldsSignsInLongDouble)
{
  const auto box = std::make_shared<ConvexBody>(MakeBox(Vec3(-0.6), Vec3(0.6)));
  const LongSide boxSide = HalfSpacesSide(BoxSides(0.6));
  const Vec3 centre(0.3, 0.25, 0.2);
  const auto ball = std::make_shared<Quadric>(MakeSphere(centre, 0.55));
  const LongSide ballSide = SphereSide(centre, 0.55);
  const Vec3 axis(0.1, 0.2, 1.0);
  const auto torus = std::make_shared<Torus>(Vec3(0.0), axis, 0.7, 0.2);
  const LongSide torusSide = TorusSide(Vec3(0.0), axis, 0.7, 0.2);
  const Vec3 normal(0.3, -0.2, 0.6);
  const auto plane = std::make_shared<Plane>(Vec3(0.1), normal);
  const LongSide planeSide = HalfSpacesSide({ { Vec3(0.1), normal } });
  const std::vector<Combined::Part> parts{ PartOf(box, boxSide), PartOf(ball, ballSide),
    PartOf(torus, torusSide), PartOf(plane, planeSide) };
  struct Case
  {
    const char* name;
    Combined::Rule rule;
    LongSide side;
  };
  const auto all = [=](const LongVec3& x) {
    return std::array{ boxSide(x), ballSide(x), torusSide(x), planeSide(x) };
  };
  const std::vector<Case> cases{ { "union of three, cut",
                                   [](const std::vector<bool>& in)
                                   { return (in[0] || in[1] || in[2]) && in[3]; },
                                   [=](const LongVec3& x)
                                   {
                                     const auto f = all(x);
                                     return std::max(std::min({ f[0], f[1], f[2] }), f[3]);
                                   } },
    { "intersection", [](const std::vector<bool>& in) { return in[0] && in[1]; },
      [=](const LongVec3& x) { return std::max(all(x)[0], all(x)[1]); } },
    { "difference", [](const std::vector<bool>& in) { return in[0] && !in[1] && !in[2]; },
      [=](const LongVec3& x)
      {
        const auto f = all(x);
        return std::max({ f[0], -f[1], -f[2] });
      } } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const Combined whole(parts, one.rule);
    EXPECT_TRUE(whole.HasSagitta());
    const ChordTally tally = CheckChords(whole, one.side, 21);
    tally.Tell(one.name);
    EXPECT_GT(tally.known, 600);
    EXPECT_GT(tally.closeKnown, 0.9 * tally.close);
    EXPECT_GT(tally.tight, 0.9 * tally.closeKnown);
  }
}

/// A bump between two hits on one plane, which neither hit indicates.
TEST(SagittaOfBooleans, SeesWhatStandsBetween)
{
  const Vec3 down(0.0, 0.0, -1.0);
  const auto floor = std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
  for (const double radius : { 1e-2, 1e-5, 1e-9 })
  {
    const auto ball = std::make_shared<Quadric>(MakeSphere(Vec3(0.0), radius));
    const Combined whole({ PartOf(floor, HalfSpacesSide({ { Vec3(0.0), Vec3(0.0, 0.0, 1.0) } })),
                           PartOf(ball, SphereSide(Vec3(0.0), radius)) },
      [](const std::vector<bool>& in) { return in[0] || in[1]; });
    const Ray a{ Vec3(-2.0 * radius, 0.0, 1.0), down };
    const Ray b{ Vec3(2.0 * radius, 0.0, 1.0), down };
    EXPECT_FALSE(std::isfinite(whole.Sagitta(a, *FirstHit(whole, a), b, *FirstHit(whole, b))));
    const Ray c{ Vec3(4.0 * radius, 0.0, 1.0), down };
    const Ray d{ Vec3(5.0 * radius, 0.0, 1.0), down };
    EXPECT_LT(whole.Sagitta(c, *FirstHit(whole, c), d, *FirstHit(whole, d)), 1e-14);
  }
}

/// A part without a bound makes the bound infinite.
TEST(SagittaOfBooleans, AsksAllParts)
{
  class Unknown final : public Surface
  {
  public:
    void Meet(const RayLanes& /*rays*/, HitSlots& /*hits*/) const override {}
    [[nodiscard]] Vec3 Normal(const SurfacePoint& /*point*/) const override { return Vec3(1.0); }
  };
  const LongSide none = [](const LongVec3& /*x*/) { return 1.0L; };
  const auto ball = std::make_shared<Quadric>(MakeSphere(Vec3(0.0), 0.5));
  const Combined whole(
    { PartOf(ball, SphereSide(Vec3(0.0), 0.5)), PartOf(std::make_shared<Unknown>(), none) },
    [](const std::vector<bool>& in) { return in[0] || in[1]; });
  EXPECT_FALSE(whole.HasSagitta());
  const Ray a{ Vec3(0.0, 0.0, 3.0), Vec3(0.0, 0.0, -1.0) };
  const Ray b{ Vec3(0.01, 0.0, 3.0), Vec3(0.0, 0.0, -1.0) };
  EXPECT_FALSE(std::isfinite(whole.Sagitta(a, *FirstHit(whole, a), b, *FirstHit(whole, b))));
}
} // namespace pixelexact::testing
