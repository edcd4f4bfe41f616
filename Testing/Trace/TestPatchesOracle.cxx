// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces of Bezier patches let no ray through; surfaces of any size; what is refused.
#include "CurvedCheck.h"

#include "SurfaceCheck.h"

#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/BezierPatches.h"

#include <limits>
#include <sstream>

namespace pixelexact::testing
{
namespace
{
/// A sphere-like body: the faces of a cube cut into n x n bicubic patches each. Points are
/// functions of their places on the cube, so that neighbours share those of their edges, to the
/// bit.
std::vector<BezierPatch> MakePatchCube(int n, double size, const Vec3& centre)
{
  std::vector<BezierPatch> patches;
  for (int face = 0; face < 6; ++face)
  {
    const int d = face / 2;
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        BezierPatch patch;
        patch.degree[0] = 3;
        patch.degree[1] = 3;
        for (int b = 0; b < 4; ++b)
        {
          for (int a = 0; a < 4; ++a)
          {
            Vec3 on;
            on[d] = face % 2 == 0 ? -1.0 : 1.0;
            on[(d + 1) % 3] = static_cast<double>(2 * (3 * i + a) - 3 * n) / (3 * n);
            on[(d + 2) % 3] = static_cast<double>(2 * (3 * j + b) - 3 * n) / (3 * n);
            const double bump = 1.0 + 0.1 * on.x * on.y - 0.08 * on.z * on.y * on.y;
            patch.points.push_back(centre + size * bump / glm::length(on) * on);
          }
        }
        patches.push_back(patch);
      }
    }
  }
  return patches;
}

std::string MessageOfPatches(const std::vector<BezierPatch>& patches)
{
  try
  {
    const BezierPatches made(patches);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}
} // namespace

TEST(PatchesOracle, ClosedSurfacesLetNothingThrough)
{
  const int count = CurvedRayCount(600);
  for (const double size : { 1.0, 1e-9, 1e-150, 1e150 })
  {
    for (const double away : { 0.0, 50.0 })
    {
      Random random(201);
      const Vec3 centre = size * away * Vec3(1.0, -0.5, 0.7);
      const auto patches = MakePatchCube(2, size, centre);
      const BezierPatches surface(patches);
      int odd = 0;
      int slipped = 0;
      int undecided = 0;
      for (int i = 0; i < count; ++i)
      {
        const BezierPatch& patch = patches[static_cast<std::size_t>(random(0.0, 23.999))];
        // Targets are corners, which are points of the surface, and other control points.
        const Vec3 target = i % 2 == 0 ? patch.points[i % 4 < 2 ? 0 : 12] : patch.points[5];
        const Vec3 inner = centre + size * 0.2 * Vec3(random(), random(), random());
        const Vec3 direction = glm::normalize((inner - target) / size);
        const Ray ray{ target - 5.0 * size * direction, direction };
        const auto hits = MeetAll(surface, { ray })[0];
        const bool isOpen = std::ranges::any_of(
          hits, [](const Hit& hit) { return hit.status == HitStatus::Undecided; });
        undecided += isOpen ? 1 : 0;
        odd += !isOpen && hits.size() % 2 == 1 ? 1 : 0;
        slipped += hits.size() < 2 ? 1 : 0;
      }
      std::ostringstream name;
      name << "size " << size << ", " << away << " sizes away";
      std::cout << "[ measured ] " << name.str() << ": " << count << " rays, " << odd << " odd, "
                << slipped << " slipped through, " << undecided << " undecided" << std::endl;
      EXPECT_EQ(odd, 0) << name.str();
      EXPECT_EQ(slipped, 0) << name.str();
      EXPECT_EQ(undecided, 0) << name.str();
    }
  }
}

TEST(PatchesOracle, WhatIsNoneIsRefused)
{
  EXPECT_NE(MessageOfPatches({}).find("there are none"), std::string::npos);
  BezierPatch patch;
  patch.degree[0] = 1;
  patch.degree[1] = 1;
  patch.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
  EXPECT_EQ(MessageOfPatches({ patch }), "");
  for (const int degree : { 0, -1, 17 })
  {
    BezierPatch bad = patch;
    bad.degree[1] = degree;
    EXPECT_NE(MessageOfPatches({ patch, bad }).find("patch 1"), std::string::npos) << degree;
  }
  BezierPatch few = patch;
  few.points.pop_back();
  EXPECT_NE(MessageOfPatches({ few }).find("3 points"), std::string::npos);
  for (const double number : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    BezierPatch bad = patch;
    bad.points[2].y = number;
    EXPECT_NE(MessageOfPatches({ bad }).find("not finite"), std::string::npos);
  }
}

/// Points, lines and folds are no surfaces that a ray crosses: nothing is drawn wrongly, soon.
TEST(PatchesOracle, DegenerateOnesEnd)
{
  BezierPatch point;
  point.degree[0] = 3;
  point.degree[1] = 3;
  point.points.assign(16, Vec3(0.25, 0.5, 0.75));
  BezierPatch line = point;
  BezierPatch fold = point;
  BezierPatch corner = point;
  for (int b = 0; b < 4; ++b)
  {
    for (int a = 0; a < 4; ++a)
    {
      const auto k = static_cast<std::size_t>(4 * b + a);
      line.points[k] = { a / 3.0, 0.0, 0.0 };
      fold.points[k] = { std::fabs(a - 1.5), b / 3.0, 0.1 * a * a };
      corner.points[k] = { a * b / 9.0, b / 3.0, 0.1 * b };
    }
  }
  Random random(202);
  for (const BezierPatch& patch : { point, line, fold, corner })
  {
    const BezierPatches surface(std::span(&patch, 1));
    double slowest = 0.0;
    for (int i = 0; i < 60; ++i)
    {
      Ray ray = RayThroughPoint(random, patch.points[static_cast<std::size_t>(i % 16)], 3.0);
      std::vector<std::vector<Hit>> hits;
      slowest = std::max(slowest, Seconds([&] { hits = MeetAll(surface, { ray }); }));
      EXPECT_LE(hits[0].size(), 4U);
      for (const Hit& hit : hits[0])
      {
        EXPECT_TRUE(IsFinite(surface.Normal({ hit.position, 0, Vec3(0.0), 0 })));
        const Vec3 off = ray.origin + hit.t * ray.direction - hit.position;
        EXPECT_LE(glm::length(off), hit.status == HitStatus::Undecided ? 0.1 : 1e-12);
      }
    }
    std::cout << "[ measured ] slowest " << 1e3 * slowest << " ms" << std::endl;
  }
}
} // namespace pixelexact::testing
