// SPDX-License-Identifier: BSD-3-Clause
#include "Block.h"
#include "RayCheck.h"
#include "Solids.h"
#include "SurfaceCheck.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Triangles.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pixelexact::testing
{
namespace
{
using Triangle = Triangles::Triangle;

Vec3 Towards(const Vec3& from, const Vec3& to)
{
  return ToDouble(Unit(Minus(ToLong(to), ToLong(from))));
}

/// Rays from a point to corners, points of edges and points of faces.
std::vector<Ray> RaysTo(const std::vector<Triangle>& faces, const Vec3& from, RandomRays& random)
{
  std::vector<Ray> rays;
  for (const auto& [a, b, c] : faces)
  {
    const Vec3 share = glm::abs(random.Vector(1.0)) + 1e-3;
    const double sum = share.x + share.y + share.z;
    for (const Vec3& to : { a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.25 * c + 0.75 * a,
           (share.x * a + share.y * b + share.z * c) / sum })
    {
      rays.push_back({ from, Towards(from, to) });
    }
  }
  return rays;
}
} // namespace

TEST(Triangles, NothingSlipsThroughBetweenThem)
{
  RandomRays random(5);
  std::size_t rays = 0;
  for (int k = 0; k < 40; ++k)
  {
    const double radius = random.Size(-6.0, 6.0);
    const Vec3 centre = random.Vector(k % 4 == 0 ? 0.0 : radius * random.Size(-2.0, 3.0));
    const std::vector<Triangle> faces = Ball(3, centre, radius);
    const Triangles ball(faces);
    const Vec3 inside = centre + random.Vector(0.4 * radius);
    for (const auto& hits : MeetAll(ball, RaysTo(faces, inside, random)))
    {
      ASSERT_EQ(hits.size(), 1U);
      ++rays;
    }
    // Rays enter and leave: two hits, or one where a ray only touches a corner or an edge.
    const Vec3 outside =
      centre + radius * random.Size(0.5, 3.0) * Towards(Vec3(0.0), random.Vector(1.0));
    for (const auto& hits : MeetAll(ball, RaysTo(faces, outside, random)))
    {
      ASSERT_LE(hits.size(), 2U);
      ++rays;
    }
  }
  EXPECT_GT(rays, 250000U);
}

TEST(Triangles, RaysMeetTheSameTogetherAndAlone)
{
  RandomRays random(8);
  const Triangles ball(Ball(3));
  const Vec3 eye(0.3, 4.0, 0.7);
  int hits = 0;
  // Neighbours far closer than triangles are large, about as far apart, and farther.
  for (const double spacing : { 1e-3, 0.1, 1.0 })
  {
    for (int k = 0; k < 40; ++k)
    {
      const Vec3 to = random.Vector(0.8);
      std::vector<Ray> rays;
      for (int i = 0; i < 150; ++i)
      {
        // Now and then through a corner or along another axis.
        const Vec3 x = i % 11 == 0 ? ball.Corners()[static_cast<std::size_t>(i)][0]
                                   : to + spacing * Vec3(0.02 * i, 0.0, 0.01 * i);
        const Vec3 from = i % 13 == 0 ? random.Vector(5.0) : eye;
        rays.push_back({ from, Towards(from, x) });
      }
      const auto together = MeetPoints(ball, rays);
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const auto alone = MeetPoints(ball, { rays[i] })[0];
        ASSERT_EQ(together[i].size(), alone.size());
        for (std::size_t n = 0; n < alone.size(); ++n)
        {
          ASSERT_EQ(together[i][n].t, alone[n].t);
          ASSERT_EQ(together[i][n].position, alone[n].position);
          ASSERT_EQ(together[i][n].point.piece, alone[n].point.piece);
          ASSERT_EQ(together[i][n].point.parameters[0], alone[n].point.parameters[0]);
          ASSERT_EQ(together[i][n].point.parameters[1], alone[n].point.parameters[1]);
          ++hits;
        }
      }
    }
  }
  EXPECT_GT(hits, 10000);
}

TEST(Triangles, HitsAreOnRayAndTriangle)
{
  RandomRays random(6);
  int certain = 0;
  int none = 0;
  for (int k = 0; k < 20000; ++k)
  {
    const double size = random.Size(-3.0, 3.0);
    const Vec3 at = random.Vector(size * random.Size(-1.0, 3.0));
    const Triangle triangle{ at + random.Vector(size), at + random.Vector(size),
      at + random.Vector(size * random.Size(-3.0, 0.0)) };
    const auto& [a, b, c] = triangle;
    const Triangles surface({ triangle });
    const LongVec3 normal = Cross(Minus(ToLong(b), ToLong(a)), Minus(ToLong(c), ToLong(a)));
    const LongPlane plane{ ToLong(a), normal };
    const Ray ray = random.Near((a + b + c) / 3.0, ToDouble(plane.normal));
    const LongVec3 origin = ToLong(ray.origin);
    const LongVec3 direction = ToLong(ray.direction);
    // Twice the area, across the ray, between it and each edge; and how far rounding may move it.
    long double least = std::numeric_limits<long double>::infinity();
    long double most = -least;
    long double slack = 0.0L;
    for (std::size_t e = 0; e < 3; ++e)
    {
      const LongVec3 p = Minus(ToLong(triangle[e]), origin);
      const LongVec3 q = Minus(ToLong(triangle[(e + 1) % 3]), origin);
      const long double area = Dot(direction, Cross(p, q));
      least = std::min(least, area);
      most = std::max(most, area);
      const long double far = std::max(Largest(p), Largest(q));
      slack = std::max(slack, 40.0L * kUnitRoundoff * far * far);
    }
    const LongVec3 p = Minus(ToLong(b), ToLong(a));
    const LongVec3 q = Minus(ToLong(c), ToLong(a));
    const long double longest = std::max(Dot(p, p), Dot(q, q));
    // The error of the plane within the triangle from the rounding of its edges.
    const long double shape =
      16.0L * kUnitRoundoff * longest * std::sqrt(longest) / std::sqrt(Dot(normal, normal));
    const auto hits = MeetAll(surface, { ray })[0];
    const bool inside = least > slack || most < -slack;
    const bool outside = least < -slack && most > slack;
    const TrueHit truth = plane.Meet(ray);
    if (outside || (inside && truth.certain && truth.t < -truth.error))
    {
      EXPECT_TRUE(hits.empty());
      ++none;
    }
    if (inside && truth.certain && truth.t > truth.error)
    {
      ASSERT_EQ(hits.size(), 1U);
      ++certain;
      EXPECT_LE(std::fabs(hits[0].t - truth.t),
        truth.error + shape / std::fabs(Dot(plane.normal, direction)));
    }
    for (const Hit& hit : hits)
    {
      const LongVec3 x = ToLong(hit.position);
      EXPECT_LE(plane.Distance(x), plane.DistanceError(x) + shape);
      EXPECT_EQ(hit.status, HitStatus::Certain);
    }
  }
  EXPECT_GT(certain, 500);
  EXPECT_GT(none, 500);
}

TEST(Triangles, AllHitsInOrderAndWithinTheInterval)
{
  std::vector<Triangle> sheets;
  for (const double z : { 3.0, 1.0, 2.0 })
  {
    sheets.push_back({ Vec3(-1.0, -1.0, z), Vec3(2.0, -1.0, z), Vec3(-1.0, 2.0, z) });
  }
  // A triangle without area, which no ray meets.
  sheets.push_back({ Vec3(-1.0, 0.0, 4.0), Vec3(0.0, 0.0, 4.0), Vec3(1.0, 0.0, 4.0) });
  const Triangles surface(sheets);
  const Ray up{ Vec3(0.0), { 0.0, 0.0, 1.0 } };
  const auto hits = HitsOf(surface, up);
  ASSERT_EQ(hits.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_EQ(hits[k].t, 1.0 + static_cast<double>(k));
    EXPECT_EQ(hits[k].position, Vec3(0.0, 0.0, 1.0 + static_cast<double>(k)));
  }
  EXPECT_EQ(HitsOf(surface, up, 1.0, 2.0).size(), 2U);
  EXPECT_EQ(HitsOf(surface, up, 1.5, 1.9).size(), 0U);
  EXPECT_EQ(HitsOf(surface, up, 2.0, 2.0).size(), 1U);
  EXPECT_TRUE(HitsOf(surface, { Vec3(0.0), { 0.0, 0.0, -1.0 } }).empty());
  // Rays in a triangle's plane, and without an end.
  EXPECT_TRUE(HitsOf(surface, { Vec3(-5.0, 0.0, 1.0), { 1.0, 0.0, 0.0 } }).empty());
  EXPECT_TRUE(HitsOf(surface, { Vec3(NAN), { 0.0, 0.0, 1.0 } }).empty());
  // The same triangle twice: a surface of one sheet.
  const Triangles twice({ sheets[0], sheets[0] });
  EXPECT_EQ(HitsOf(twice, up).size(), 2U);
}

TEST(Triangles, NormalsAreTheTriangles)
{
  const Triangles surface({ { Vec3(0.0, 0.0, 1.0), Vec3(1e-150, 0.0, 1.0), Vec3(0.0, 1e-150, 1.0) },
    { Vec3(1.0, 0.0, 0.0), Vec3(1.0, 1e100, 0.0), Vec3(1.0, 0.0, 1e100) } });
  SurfacePoint point;
  point.piece = 0;
  EXPECT_EQ(surface.Normal(point), Vec3(0.0, 0.0, 1.0));
  point.piece = 1;
  EXPECT_EQ(surface.Normal(point), Vec3(1.0, 0.0, 0.0));
}

/// Samples store the triangle and the position on it.
TEST(Triangles, SamplesNameThePiece)
{
  const Block block;
  const auto ball = std::make_shared<Triangles>(Ball(1, Vec3(0.1, 0.0, 0.0), 0.8));
  const Scene scene{ block.scene_.locator, { { ball, &block.field_ } }, {} };
  const Camera camera = ViewAlongZ(24, 18);
  const SampleBuffers samples =
    Trace(scene, camera, {}, { .corners = kAll | Buffer::Piece }).corners;
  int seen = 0;
  for (int y = 0, i = 0; y <= 18; ++y)
  {
    for (int x = 0; x <= 24; ++x, ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const auto hits =
        MeetPoints(*ball, std::vector<Ray>{ camera.At(x, y) }, std::vector{ kNearest }).front();
      const bool isSeen = samples.verdict[at] == static_cast<std::uint8_t>(PixelVerdict::Exact);
      EXPECT_EQ(samples.piece[at], isSeen ? hits.front().point.piece : -1);
      EXPECT_EQ(samples.pieceU[at], isSeen ? hits.front().point.parameters[0] : 0.0);
      EXPECT_EQ(samples.pieceV[at], isSeen ? hits.front().point.parameters[1] : 0.0);
      seen += isSeen ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 90);
}

TEST(Triangles, NonsenseIsRefused)
{
  EXPECT_NE(MessageOf([] { Triangles({}); }).find("there are none"), std::string::npos);
  std::vector<Triangle> faces = Ball(1);
  faces[7][1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(MessageOf([&] { (void)Triangles(faces); }).find("triangle 7"), std::string::npos);
}
} // namespace pixelexact::testing
