// SPDX-License-Identifier: BSD-3-Clause
#include "BoxGrid.h"

#include "ClippedSurface.h"
#include "HighOrderModel.h"
#include "Trace/Plane.h"
#include "Trace/RayCheck.h"
#include "Trace/Tracer.h"

#include <glm/geometric.hpp>

namespace pixelexact::testing
{
namespace
{
/// The sphere of a radius around the world's origin: a surface that is behind itself.
class Sphere final : public Surface
{
public:
  explicit Sphere(double radius)
    : Radius(radius)
  {
  }

  void NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const override
  {
    for (int i = 0; i < rays.count; ++i)
    {
      const Vec3 o(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
      const Vec3 along(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
      const double middle = -glm::dot(o, along);
      const double half = std::sqrt(middle * middle - glm::dot(o, o) + Radius * Radius);
      hits.t[i] = kNoHit;
      for (const double t : { middle + half, middle - half })
      {
        hits.t[i] = t > tMin[i] ? t : hits.t[i];
      }
      const Vec3 x = o + (hits.t[i] < kNoHit ? hits.t[i] : 0.0) * along;
      for (int d = 0; d < 3; ++d)
      {
        hits.position[d][i] = x[d];
      }
    }
  }
  [[nodiscard]] int MostHits() const override { return 2; }
  [[nodiscard]] Vec3 Normal(const Vec3& position) const override { return position / Radius; }

private:
  double Radius;
};

/// Planes as one surface.
class Planes final : public Surface
{
public:
  void Add(const Vec3& origin, const Vec3& normal)
  {
    Parts.emplace_back(origin, normal);
    Truth.emplace_back(ToLong(origin), ToLong(normal));
  }

  void NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const override
  {
    for (int i = 0; i < rays.count; ++i)
    {
      const Ray ray{ { rays.origin[0][i], rays.origin[1][i], rays.origin[2][i] },
        { rays.direction[0][i], rays.direction[1][i], rays.direction[2][i] } };
      Hit nearest;
      for (const Plane& plane : Parts)
      {
        const Hit hit = NextHitOf(plane, ray, tMin[i]);
        nearest = hit.t < nearest.t ? hit : nearest;
      }
      hits.t[i] = nearest.t;
      for (int d = 0; d < 3; ++d)
      {
        hits.position[d][i] = nearest.position[d];
      }
    }
  }
  [[nodiscard]] int MostHits() const override { return static_cast<int>(Parts.size()); }
  [[nodiscard]] Vec3 Normal(const Vec3& position) const override
  {
    return Parts.front().Normal(position);
  }

  std::vector<LongPlane> Truth;

private:
  std::vector<Plane> Parts;
};

/// Which of the hits are in all of the half-spaces; those that rounding may put on either side are
/// not certain.
std::vector<TrueHit> Clip(const std::vector<TrueHit>& hits, const Ray& ray,
  const LongVec3& surfaceOrigin, const std::vector<KeptHalfSpace>& kept)
{
  std::vector<TrueHit> left;
  for (TrueHit hit : hits)
  {
    bool out = false;
    for (const auto& [a, b, c, d] : kept)
    {
      const LongVec3 across{ a, b, c };
      const long double height = Dot(across, hit.position) + d;
      // How far rounding may move the position, and that of the sum itself.
      const long double moved = RayError(ray, hit.t, surfaceOrigin) +
        (hit.certain ? hit.error * Largest(ToLong(ray.direction)) : hit.error);
      const long double error = Dot(Absolute(across), LongVec3{ moved, moved, moved }) +
        4.0L * kUnitRoundoff * (Dot(Absolute(across), Absolute(hit.position)) + std::fabs(d));
      out = out || height < -error;
      hit.certain = hit.certain && height > error;
    }
    if (!out)
    {
      left.push_back(hit);
    }
  }
  return left;
}
} // namespace

TEST(ClippedSurface, RaysGoOnToWhatIsBehindThePartCutAway)
{
  const auto sphere = std::make_shared<Sphere>(1.0);
  // Its upper cap and its right-hand side are cut away.
  const ClippedSurface clipped(sphere, { { 0.0, 0.0, -1.0, 0.5 }, { -1.0, 0.0, 0.0, 0.75 } });
  const auto meet = [&clipped](const Vec3& origin, const Vec3& direction, double tMin = 0.0) {
    return NextHitOf(clipped, { origin, direction }, tMin);
  };
  const Vec3 down(0.0, 0.0, -1.0);
  // The rounding of the root's radicand, of numbers up to 5, over twice the root.
  constexpr double kError = 4e-15;
  // Through the cap's hole to the bottom: sqrt(1 - 0.6^2) = 0.8.
  const Hit bottom = meet({ 0.6, 0.0, 2.0 }, down);
  EXPECT_NEAR(bottom.t, 2.8, kError);
  EXPECT_NEAR(bottom.position.z, -0.8, kError);
  EXPECT_EQ(bottom.position.x, 0.6);
  EXPECT_EQ(meet({ 0.6, 0.0, 2.0 }, down, bottom.t).t, kNoHit);
  // Beside the hole the nearer part is there, and the other one behind it.
  const Hit side = meet({ 0.0, 0.96, 2.0 }, down);
  EXPECT_NEAR(side.position.z, 0.28, kError);
  EXPECT_NEAR(meet({ 0.0, 0.96, 2.0 }, down, side.t).position.z, -0.28, kError);
  // Cut away in front and behind; a ray that starts behind the hole; one along the edge.
  EXPECT_EQ(meet({ 0.8, 0.0, 2.0 }, down).t, kNoHit);
  EXPECT_NEAR(meet({ 0.6, 0.0, 0.0 }, down).t, 0.8, kError);
  EXPECT_EQ(meet({ 2.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }).t, 3.0);
  EXPECT_EQ(clipped.Normal({ 0.6, 0.0, -0.8 }), sphere->Normal({ 0.6, 0.0, -0.8 }));
}

TEST(ClippedSurface, WhatLiesOnTheClippingPlaneIsKept)
{
  const auto plane = std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
  const ClippedSurface clipped(plane, { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0, 0.5 } });
  const auto meet = [&clipped](double x, double y) {
    return NextHitOf(clipped, { { x, y, 1.0 }, { 0.0, 0.0, -1.0 } }, 0.0).t;
  };
  EXPECT_EQ(meet(0.1, 0.0), 1.0);
  EXPECT_EQ(meet(-0.1, 0.0), kNoHit);
  EXPECT_EQ(meet(0.1, 0.6), kNoHit);
  EXPECT_EQ(meet(0.0, 0.5), 1.0);
}

TEST(ClippedSurface, HitsAreThoseOfTheWholeThatAreKeptAndNoneIsMissing)
{
  RandomRays random(71);
  int certain = 0;
  int cut = 0;
  for (int k = 0; k < 200; ++k)
  {
    const double size = random.Size(-3.0, 3.0);
    const auto planes = std::make_shared<Planes>();
    std::vector<KeptHalfSpace> kept;
    const Vec3 middle = random.Vector(1e2 * size);
    Vec3 through;
    Vec3 normal;
    for (int i = 0; i < 5; ++i)
    {
      through = middle + random.Vector(size);
      normal = random.Vector(1.0);
      planes->Add(through, normal);
    }
    for (int i = 0; i < 2; ++i)
    {
      const Vec3 across = random.Vector(1.0);
      kept.push_back(
        { across.x, across.y, across.z, -glm::dot(across, middle + random.Vector(0.5 * size)) });
    }
    const ClippedSurface clipped(planes, kept);
    std::vector<Ray> rays;
    std::vector<std::vector<TrueHit>> hits;
    std::vector<double> tMin;
    for (int i = 0; i < 29; ++i)
    {
      rays.push_back(random.Near(through, normal));
      std::vector<TrueHit> whole;
      for (const LongPlane& plane : planes->Truth)
      {
        whole.push_back(plane.Meet(rays.back()));
      }
      hits.push_back(Clip(whole, rays.back(), ToLong(middle), kept));
      tMin.push_back(random.Start(whole.front().t));
      cut += static_cast<int>(whole.size() - hits.back().size());
    }
    const auto found = AllHits(clipped, rays, tMin);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      certain += ExpectHits(found[i], hits[i], tMin[i]);
    }
  }
  EXPECT_GT(certain, 3000);
  EXPECT_GT(cut, 10000);
}

/// In a picture: each pixel shows the nearest part that is left, of either surface, at its place.
TEST(ClippedSurface, PicturesShowWhatIsBehind)
{
  const auto grid = BoxGrid(2);
  const auto model = HighOrderModel::From(grid);
  const KeptHalfSpace kept{ 0.5, 0.25, -1.0, 0.25 };
  constexpr double kRadius = 0.75;
  constexpr double kFloor = -0.5;
  Scene scene;
  scene.locator = &model->GetLocator();
  scene.field = model->FindField("u");
  scene.surfaces = { std::make_shared<ClippedSurface>(
                       std::make_shared<Sphere>(kRadius), std::vector<KeptHalfSpace>{ kept }),
    std::make_shared<Plane>(Vec3(0.0, 0.0, kFloor), Vec3(0.0, 0.0, 1.0)) };
  CameraView view;
  view.position = { 0.0, 0.0, 4.0 };
  view.parallel = true;
  view.parallelScale = 0.95;
  constexpr int kSize = 75;
  const Camera camera(view, kSize, kSize);
  const Frame frame = Trace(scene, camera, {},
    { .centres =
        Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Depth | Buffer::Verdict });
  int seen[3] = { 0, 0, 0 };
  for (int at = 0; at < kSize * kSize; ++at)
  {
    const int row = at / kSize;
    const LongVec3 origin = ToLong(camera.At(at % kSize + 0.5, row + 0.5).origin);
    const long double x = origin[0];
    const long double y = origin[1];
    const long double square = kRadius * kRadius - x * x - y * y;
    const long double z = std::sqrt(std::max(0.0L, square));
    const auto height = [&](long double atZ)
    { return kept[0] * x + kept[1] * y + kept[2] * atZ + kept[3]; };
    const auto close = [](long double number) { return std::fabs(number) < 1e-9L; };
    if (close(square) || close(height(z)) || close(height(-z)) || close(z + kFloor))
    {
      continue;
    }
    LongVec3 expected{ x, y, kFloor };
    LongVec3 normal{ 0.0L, 0.0L, 1.0L };
    int part = 2;
    for (const int sign : { 1, -1 })
    {
      if (square > 0.0L && part == 2 && height(sign * z) > 0.0L && sign * z > kFloor)
      {
        expected[2] = sign * z;
        normal = Times(1.0L / kRadius, expected);
        part = sign > 0 ? 0 : 1;
      }
    }
    ++seen[part];
    const auto i = static_cast<std::size_t>(at);
    ASSERT_EQ(frame.centres.verdict[i], static_cast<std::uint8_t>(PixelVerdict::Exact)) << at;
    // The sphere's steep rim makes of a rounding a larger one.
    const double rounding = 1e-15 * (1.0 + (part < 2 ? 1.0 / static_cast<double>(z) : 0.0));
    EXPECT_NEAR(frame.centres.depth[i], static_cast<double>(4.0L - expected[2]), 4.0 * rounding);
    EXPECT_LE(Largest(Minus(ToLong(frame.centres.position[i]), expected)), 4.0 * rounding);
    EXPECT_LE(Largest(Minus(ToLong(frame.centres.normal[i]), normal)), 8.0 * rounding);
    const Vec3 p = ToDouble(expected);
    EXPECT_NEAR(frame.centres.value[i], FieldU(p.x, p.y, p.z), 1e-14 + 4.0 * rounding);
  }
  // Upper half, lower half seen through the hole, the floor beside and behind.
  for (const int pixels : seen)
  {
    EXPECT_GT(pixels, 300);
  }
}
} // namespace pixelexact::testing
