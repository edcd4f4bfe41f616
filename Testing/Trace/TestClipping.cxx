// SPDX-License-Identifier: BSD-3-Clause
// Half-spaces that are kept: what rays see of the rest, against the positions of all hits.
#include "FrameCheck.h"
#include "SheetCheck.h"

#include "Trace/Surfaces/Quadric.h"

namespace pixelexact::testing
{
namespace
{
/// A block, and planes and spheres in it.
struct Clipped
{
  Block block;
  TrueScene scene{ block };
  const Field& field =
    block.Add(1, [](const LongVec3& x, long double* u) { u[0] = Block::CurvedAt(x); });

  Layer MakeLayer(bool translucent) const
  {
    return { nullptr, &field, 0, Precision::Double, translucent };
  }
  void AddPlane(const Vec3& through, const Vec3& normal, bool translucent)
  {
    scene.AddPlane(through, normal, MakeLayer(translucent), &Block::CurvedAt);
  }
  void AddSphere(const Vec3& centre, double radius, bool translucent)
  {
    scene.AddSphere(centre, radius, MakeLayer(translucent), &Block::CurvedAt);
  }
  [[nodiscard]] Frame Render(const CameraView& view, int width, int height) const
  {
    return Trace(scene.Traced, Camera(view, width, height), {}, { .centres = kAllWithLayer });
  }
};

CameraView MakeClippedView(bool parallel)
{
  CameraView view;
  view.position = { -1.5, 2.0, 4.0 };
  view.viewUp = { 0.1, 1.0, 0.2 };
  view.parallel = parallel;
  view.parallelScale = 1.4;
  view.viewAngle = 34.0;
  return view;
}

KeptHalfSpace RandomHalfSpace(Random& random)
{
  // The normal has any length; most of the cube is kept.
  const double size = std::pow(10.0, random(-3.0, 3.0));
  const Vec3 normal(random(), random(), random());
  return { size * normal.x, size * normal.y, size * normal.z, size * random(0.0, 1.2) };
}
} // namespace

TEST(Clipping, OnlyWhatIsKeptIsSeen)
{
  Clipped clipped;
  clipped.AddPlane({ 0.0, 0.1, 0.2 }, { 0.3, -0.2, 1.0 }, false);
  clipped.AddSphere({ 0.2, 0.0, 0.0 }, 0.7, true);
  clipped.AddSphere({ -0.3, -0.2, 0.1 }, 0.8, false);
  clipped.AddPlane({ 0.0, 0.0, 0.6 }, { 1.0, 0.2, 0.5 }, true);
  Random random(17);
  int sheets = 0;
  int nothing = 0;
  int uncertain = 0;
  for (int scenes = 0; scenes < 24; ++scenes)
  {
    SCOPED_TRACE(scenes);
    clipped.scene.Traced.kept.clear();
    for (int k = 0; k < 1 + scenes % 4; ++k)
    {
      clipped.scene.Traced.kept.push_back(RandomHalfSpace(random));
    }
    const CameraView view = MakeClippedView(scenes % 2 == 0);
    const SheetTally tally = ExpectSheets(clipped.Render(view, 24, 21), clipped.scene, view);
    sheets += tally.WithDepth(2) + tally.WithDepth(3);
    nothing += tally.WithDepth(0);
    uncertain += tally.uncertain;
  }
  EXPECT_GT(sheets, 500);
  EXPECT_GT(nothing, 1000);
  EXPECT_LT(uncertain, 10);
}

/// Half-spaces that all rays run along, on either side of their planes.
TEST(Clipping, RaysAlongTheCut)
{
  Clipped clipped;
  clipped.AddSphere(Vec3(0.0), 0.9, true);
  CameraView view;
  view.position = { 0.0, 0.0, 5.0 };
  view.parallel = true;
  view.parallelScale = 1.0;
  clipped.scene.Traced.kept = { { 1.0, 0.0, 0.0, 0.33 }, { 0.0, -3.0, 0.0, 1.0 },
    { -0.5, 0.5, 0.0, 0.41 } };
  const SheetTally tally = ExpectSheets(clipped.Render(view, 40, 40), clipped.scene, view);
  EXPECT_GT(tally.WithDepth(2), 400);
  EXPECT_GT(tally.WithDepth(0), 400);
  EXPECT_EQ(tally.uncertain, 0);

  // All rays at once, on the wrong side.
  clipped.scene.Traced.kept = { { 1.0, 0.0, 0.0, -2.0 } };
  const Frame none = clipped.Render(view, 40, 40);
  EXPECT_EQ(none.counters.nothing, 1600);
  EXPECT_EQ(none.counters.surfaceHits, 0);
  EXPECT_TRUE(none.centres.behind.empty());
}

TEST(Clipping, NothingIsLeft)
{
  Clipped clipped;
  clipped.AddSphere({ 0.1, 0.0, 0.0 }, 0.9, true);
  clipped.AddPlane(Vec3(0.0), { 0.2, 0.1, 1.0 }, false);
  // Each keeps some, both together nothing; and half-spaces without a direction.
  const std::vector<std::vector<KeptHalfSpace>> nothing = {
    { { 1.0, 2.0, 3.0, -0.1 }, { -1.0, -2.0, -3.0, 0.0 } },
    { { 0.0, 0.0, 0.0, -1.0 } },
  };
  for (const auto& kept : nothing)
  {
    clipped.scene.Traced.kept = kept;
    for (const bool parallel : { false, true })
    {
      const Frame frame = clipped.Render(MakeClippedView(parallel), 30, 30);
      EXPECT_EQ(frame.counters.nothing, 900);
      EXPECT_EQ(frame.counters.surfaceHits, 0);
    }
  }
  clipped.scene.Traced.kept = { { 0.0, 0.0, 0.0, 1.0 } };
  const CameraView view = MakeClippedView(false);
  const SheetTally all = ExpectSheets(clipped.Render(view, 30, 30), clipped.scene, view);
  EXPECT_GT(all.WithDepth(2), 200);
}

/// The camera sees into the sphere, whose near half is clipped away.
TEST(Clipping, AHollowSphereShowsItsFarHalf)
{
  const Vec3 centre(0.1, -0.1, 0.05);
  constexpr double kRadius = 0.8;
  for (const bool parallel : { false, true })
  {
    Clipped clipped;
    clipped.AddSphere(centre, kRadius, false);
    const CameraView view = MakeClippedView(parallel);
    const LongVec3 forward = Unit(Minus(ToLong(view.focalPoint), ToLong(view.position)));
    const Vec3 away = ToDouble(forward);
    const double through = static_cast<double>(Dot(ToLong(away), ToLong(centre)));
    clipped.scene.Traced.kept = { { away.x, away.y, away.z, -through } };
    constexpr int kSize = 61;
    const Frame frame = clipped.Render(view, kSize, kSize);
    EXPECT_LT(ExpectSheets(frame, clipped.scene, view).uncertain, 5);
    int seen = 0;
    for (int y = 0; y < kSize; ++y)
    {
      for (int x = 0; x < kSize; ++x)
      {
        const auto at = static_cast<std::size_t>(y * kSize + x);
        const LongRay ray = RayThrough(view, kSize, kSize, x + 0.5L, y + 0.5L);
        // Both roots; the far one is wanted where it is in the kept half.
        const LongVec3 from = Minus(ray.origin, ToLong(centre));
        const long double b = Dot(from, ray.direction);
        const long double d = b * b - Dot(from, from) + 0.8L * 0.8L;
        if (d < 1e-6L)
        {
          continue;
        }
        const long double far = -b + std::sqrt(d);
        const LongVec3 position = Plus(from, Times(far, ray.direction));
        if (Dot(forward, position) > 1e-6L)
        {
          ++seen;
          EXPECT_NEAR(frame.centres.depth[at], static_cast<double>(far), 1e-13);
          // The normal faces the camera from inside.
          const Vec3& normal = frame.centres.normal[at];
          EXPECT_NEAR(
            std::fabs(static_cast<double>(Dot(ToLong(normal), Unit(position)))), 1.0, 1e-12);
        }
      }
    }
    EXPECT_GT(seen, 700);
    EXPECT_GE(frame.counters.exact, seen);
  }
}

/// Next to a curved surface that no ray meets, rays are clipped to the mesh's box. Their samples of
/// a plane are bitwise the same, also at the mesh's border and at a distance at which a rounding is
/// a pixel.
TEST(Clipping, ToTheMeshsBoxLosesNothingOfAPlane)
{
  Block block;
  const Scene plane = block.WithPlane({ 0.0, 0.0, 0.1 }, { 0.1, 0.2, 1.0 });
  Scene beside = plane;
  beside.layers.push_back(
    { std::make_shared<Quadric>(MakeSphere({ 0.0, 0.0, -50.0 }, 1.0)), &block.field_ });
  // The plane touches a face of the cube, or one of its edges.
  for (const Vec3& border : { Vec3(1.0, 0.3, -0.06), Vec3(-1.0, 1.0, 0.0) })
  {
    for (const double distance : { 5.0, 1e4, 1e8 })
    {
      for (const double scale : { 1.5, 1e-6, 1e-8, 1e-14 })
      {
        CameraView view;
        view.focalPoint = border;
        view.position = border + distance * Vec3(0.5, -0.7, 0.6);
        view.parallel = true;
        view.parallelScale = scale;
        const Camera camera(view, 24, 24);
        const Frame wanted = Trace(plane, camera, {}, { .centres = kAll });
        const Frame clipped = Trace(beside, camera, {}, { .centres = kAll });
        SCOPED_TRACE(std::to_string(distance) + " " + std::to_string(scale));
        ExpectSame(clipped.centres, wanted.centres);
      }
    }
  }
}
} // namespace pixelexact::testing
