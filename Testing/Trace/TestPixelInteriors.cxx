// SPDX-License-Identifier: BSD-3-Clause
// Values inside of pixels on whose edges there are none, against fields in closed form.
#include "BentCube.h"
#include "Block.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
ContourMethod Inside()
{
  ContourMethod method;
  method.interior = true;
  return method;
}

struct PixelResult
{
  std::vector<std::uint8_t> verdicts;
  ContourCounters counters;

  [[nodiscard]] std::uint8_t At(int x, int y) const
  {
    return verdicts[static_cast<std::size_t>(y * kVerdictWidth + x)];
  }
};

PixelResult CertifyPixels(const Scene& scene, const CameraView& view,
  const std::vector<double>& values, const ContourMethod& method = Inside())
{
  ContourCertifier certifier({ values }, method);
  Trace(scene, Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
  return { certifier.Verdicts(), certifier.Counters() };
}

/// The first intersection of the ray through a position with a surface.
Vec3 FindFirstHit(const Surface& surface, const CameraView& view, double px, double py)
{
  return HitsOf(surface, Camera(view, kVerdictWidth, kVerdictHeight).At(px, py)).front().position;
}

long double SquaredDistance(const LongVec3& x, const Vec3& from)
{
  const LongVec3 d = Minus(x, ToLong(from));
  return Dot(d, d);
}

/// The square of a part of a pixel's width, on the surface there.
double SquareOf(const Surface& surface, const CameraView& view, double px, double py, double part)
{
  return std::pow(part *
      glm::distance(FindFirstHit(surface, view, px, py), FindFirstHit(surface, view, px + 1.0, py)),
    2.0);
}

/// The block with a field, on a surface.
struct Shown
{
  Shown(std::shared_ptr<const Surface> surface,
    const std::function<long double(const LongVec3& x)>& value)
    : scene(block.scene_)
  {
    const Field& field = block.Add(1, [&](const LongVec3& x, long double* u) { u[0] = value(x); });
    scene.layers = { { std::move(surface), &field } };
  }

  Block block;
  Scene scene;
};
} // namespace

/// A minimum's loop about a tenth of a pixel wide, on flat and round surfaces; below the minimum no
/// pixel has anything.
TEST(PixelInteriors, LoopsOfATenthOfAPixelAreIn)
{
  const std::shared_ptr<const Surface> surfaces[] = { std::make_shared<Plane>(
                                                        kPlaneOrigin, kPlaneNormal),
    std::make_shared<Quadric>(MakeSphere(Vec3(0.05, -0.1, 0.1), 0.7)) };
  for (const auto& surface : surfaces)
  {
    for (const bool parallel : { false, true })
    {
      SCOPED_TRACE(::testing::Message() << surface->IsFlat() << ", parallel " << parallel);
      const CameraView view = Oblique(parallel);
      const Vec3 least = FindFirstHit(*surface, view, 30.37, 25.44);
      const Shown shown(surface, [&](const LongVec3& x) { return SquaredDistance(x, least); });
      const double square = SquareOf(*surface, view, 30.37, 25.44, 0.05);
      const PixelResult edges = CertifyPixels(shown.scene, view, { square }, {});
      EXPECT_EQ(edges.At(30, 25), kOut);
      const PixelResult told = CertifyPixels(shown.scene, view, { square });
      EXPECT_EQ(told.At(30, 25), kIn);
      EXPECT_EQ(told.counters.in, 1);
      EXPECT_EQ(told.counters.loops, 1);
      const PixelResult below = CertifyPixels(shown.scene, view, { -square });
      EXPECT_EQ(below.counters.in, 0);
      if (surface->IsFlat())
      {
        EXPECT_EQ(told.counters.undecided, 0);
        EXPECT_EQ(below.counters.undecided, 0);
      }
    }
  }
}

/// Minima of two elements that meet in the pixel (32, 34), inside and outside of it.
TEST(PixelInteriors, TwoLoops)
{
  CameraView view;
  view.position = { 0.0, 0.0, 10.0 };
  view.parallel = true;
  view.parallelScale = 1.2;
  const auto surface = std::make_shared<Plane>(Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, 1.0));
  for (const double apart : { 0.5, 3.0 })
  {
    SCOPED_TRACE(apart);
    const Vec3 least[2] = { FindFirstHit(*surface, view, 32.6 - 0.5 * apart, 34.4),
      FindFirstHit(*surface, view, 32.6 + 0.5 * apart, 34.4) };
    const Block block;
    ExpansionBuilder values(1);
    for (int e = 0; e < 8; ++e)
    {
      values.Add(UniformSpace(Shape::Hexahedron, 4),
        [&](const LongVec3& xi, long double* u)
        { u[0] = SquaredDistance(Block::Map(e, xi), least[e & 1]); });
    }
    const Field field{ "two", values.View() };
    const Scene scene{ block.scene_.locator, { { surface, &field } }, {} };
    const PixelResult told =
      CertifyPixels(scene, view, { SquareOf(*surface, view, 32.0, 34.0, 0.05) });
    const bool areInOne = apart < 1.0;
    EXPECT_EQ(told.At(32, 34), areInOne ? kIn : kOut);
    EXPECT_EQ(told.At(31, 34), areInOne ? kOut : kIn);
    EXPECT_EQ(told.At(34, 34), areInOne ? kOut : kIn);
    EXPECT_EQ(told.counters.loops, areInOne ? 1 : 2);
    EXPECT_EQ(told.counters.in, told.counters.loops);
    EXPECT_EQ(told.counters.undecided, 0);
  }
}

/// The least value itself: never out, and in where a sample meets it.
TEST(PixelInteriors, AMinimumIsNotOut)
{
  const CameraView view = Oblique(true);
  const auto surface = std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal);
  for (const double px : { 30.5, 30.37 })
  {
    const Vec3 least = FindFirstHit(*surface, view, px, 25.5);
    const Shown shown(surface, [&](const LongVec3& x) { return SquaredDistance(x, least); });
    const PixelResult told = CertifyPixels(shown.scene, view, { 0.0 });
    EXPECT_NE(told.At(30, 25), kOut) << px;
    EXPECT_LE(told.counters.in + told.counters.undecided, 1) << px;
  }
}

TEST(PixelInteriors, PlateausAndSaddlesStay)
{
  const CameraView view = Oblique(false);
  const auto surface = std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal);
  const Shown plateau(surface, [](const LongVec3& /*x*/) { return 0.375L; });
  const PixelResult edges = CertifyPixels(plateau.scene, view, { 0.375 }, {});
  EXPECT_EQ(CertifyPixels(plateau.scene, view, { 0.375 }).verdicts, edges.verdicts);
  EXPECT_GT(edges.counters.in, 300);
  const PixelResult others = CertifyPixels(plateau.scene, view, { 0.375 - 1e-9, 0.375 + 1e-9 });
  EXPECT_EQ(std::ranges::count(others.verdicts, kOut), kVerdictWidth * kVerdictHeight);

  const Shown saddle(surface, [](const LongVec3& x) { return (x[0] - 0.23L) * (x[1] + 0.37L); });
  for (const double value : { 0.0, 1e-5, -1e-5 })
  {
    const PixelResult told = CertifyPixels(saddle.scene, view, { value });
    EXPECT_EQ(told.verdicts, CertifyPixels(saddle.scene, view, { value }, {}).verdicts) << value;
    EXPECT_EQ(told.counters.loops, 0);
  }
}

/// Held against samples inside of pixels, in long double.
TEST(PixelInteriors, NoVerdictIsWrong)
{
  struct Case
  {
    std::shared_ptr<const Surface> surface;
    LongHits hits;
  };
  const Vec3 centre(0.05, -0.1, 0.1);
  const Case cases[] = { { std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal),
                           PlaneHits(kPlaneOrigin, kPlaneNormal) },
    { std::make_shared<Quadric>(MakeSphere(centre, 0.7)), RoundHits(centre, Vec3(0.0), 0.7) } };
  const BentCube cube(kShapes);
  const CameraView view = Oblique(false);
  const std::vector<double> values{ -2.0, -0.7, -0.1, 0.05, 0.4, 1.1 };
  constexpr int kSteps = 8;
  for (const Case& one : cases)
  {
    const Sight sight = SightOf(view, kVerdictWidth, kVerdictHeight, one.hits,
      [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); });
    const PixelResult told = CertifyPixels(cube.With(one.surface), view, values);
    int wrong = 0;
    for (int y = 0; y < kVerdictHeight; ++y)
    {
      for (int x = 0; x < kVerdictWidth; ++x)
      {
        if (told.At(x, y) != kOut)
        {
          continue;
        }
        for (const double value : values)
        {
          bool below = false;
          bool above = false;
          for (int k = 0; k <= kSteps * (kSteps + 2); ++k)
          {
            const auto seen = sight(x + static_cast<long double>(k % (kSteps + 1)) / kSteps,
              y + static_cast<long double>(k / (kSteps + 1)) / kSteps);
            below = below || (seen && seen->sheet % 16 == 0 && seen->value < value - 1e-11L);
            above = above || (seen && seen->sheet % 16 == 0 && seen->value > value + 1e-11L);
          }
          wrong += below && above ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(told.counters.in, 150);
    if (one.surface->IsFlat())
    {
      EXPECT_LE(told.counters.undecided, 1);
    }
  }
}

/// Elements of constant values, all of them inside of a pixel.
TEST(PixelInteriors, JumpsInsideAreIn)
{
  Block block;
  ExpansionBuilder values(1);
  for (int e = 0; e < 8; ++e)
  {
    values.Add(UniformSpace(Shape::Hexahedron, 1),
      [e](const LongVec3& /*xi*/, long double* u) { u[0] = e & 1; });
  }
  const Field field{ "jump", values.View() };
  const Scene scene{ block.scene_.locator,
    { { std::make_shared<Plane>(Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, 1.0)), &field } }, {} };
  CameraView view;
  view.position = { 0.0, 0.0, 10.0 };
  view.parallel = true;
  // A pixel is 3.3 wide, the block 2.
  view.parallelScale = 80.0;
  const double pixel = 2.0 * view.parallelScale / kVerdictHeight;
  const auto lookAt = [&](double px, double py)
  {
    view.position.x = view.focalPoint.x = (0.5 * kVerdictWidth - px) * pixel;
    view.position.y = view.focalPoint.y = (0.5 * kVerdictHeight - py) * pixel;
  };
  lookAt(32.5, 24.45);
  EXPECT_EQ(CertifyPixels(scene, view, { 0.5 }, {}).At(32, 24), kOut);
  EXPECT_EQ(CertifyPixels(scene, view, { 0.5 }).At(32, 24), kIn);
  // Across an edge of which no end is in the mesh.
  lookAt(32.5, 24.05);
  const PixelResult told = CertifyPixels(scene, view, { 0.5 }, {});
  EXPECT_EQ(told.At(32, 24), kIn);
  EXPECT_EQ(told.At(32, 23), kIn);
}

/// Their edges are proven, their squares are not.
TEST(PixelInteriors, InsidesOfToriAreUndecided)
{
  const Shown shown(std::make_shared<Torus>(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 0.6, 0.25),
    [](const LongVec3& x) { return x[0]; });
  const PixelResult told = CertifyPixels(shown.scene, Oblique(false), { 0.25 });
  EXPECT_GT(told.counters.in, 20);
  EXPECT_EQ(told.counters.loops, 0);
  EXPECT_GT(std::ranges::count(told.verdicts, kUndecided), 200);
}

TEST(PixelInteriors, NotByThePapersMethod)
{
  ContourMethod method = Inside();
  method.subdivisions = 2;
  EXPECT_THROW(ContourCertifier(std::vector<std::vector<double>>{ { 0.5 } }, method), Error);
}
} // namespace pixelexact::testing
