// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on pixels that show tori, bodies with creases, discs, triangles and patches, against
// many samples of a field in closed form.
#include "BentCube.h"
#include "Solids.h"
#include "SurfaceHits.h"

#include "Trace/Surfaces/BezierPatches.h"
#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Disc.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
struct SurfaceCut
{
  const char* name;
  std::shared_ptr<const Surface> surface;
  LongHits hits;
  double undecided; ///< at most, of pixels that show it
};

/// z = 0.1 + 0.1 x + 0.3 x^2 - 0.2 y^2 + 0.25 x y, as two patches that share the edge x = 0.
std::vector<BezierPatch> Saddle()
{
  std::vector<BezierPatch> all;
  for (const double end : { -0.9, 0.9 })
  {
    const double x[2] = { std::min(end, 0.0), std::max(end, 0.0) };
    const double y[2] = { -0.8, 0.8 };
    BezierPatch patch{ { 2, 2 }, {} };
    for (int i = 0; i <= 2; ++i)
    {
      for (int j = 0; j <= 2; ++j)
      {
        const auto blossom = [](const double(&at)[2], int k) {
          return k == 0 ? at[0] * at[0] : k == 1 ? at[0] * at[1] : at[1] * at[1];
        };
        const double px = x[0] + 0.5 * i * (x[1] - x[0]);
        const double py = y[0] + 0.5 * j * (y[1] - y[0]);
        patch.points.emplace_back(
          px, py, 0.1 + 0.1 * px + 0.3 * blossom(x, i) - 0.2 * blossom(y, j) + 0.25 * px * py);
      }
    }
    all.push_back(patch);
  }
  return all;
}

LongHits SaddleHits()
{
  return [](const LongRay& ray)
  {
    const long double x = ray.origin[0];
    const long double y = ray.origin[1];
    const long double z = ray.origin[2];
    const long double a = ray.direction[0];
    const long double b = ray.direction[1];
    const long double c = ray.direction[2];
    const long double squares = 0.3L * a * a - 0.2L * b * b + 0.25L * a * b;
    const long double slope = 0.1L * a + 0.6L * x * a - 0.4L * y * b + 0.25L * (x * b + y * a) - c;
    const long double value = 0.1L + 0.1L * x + 0.3L * x * x - 0.2L * y * y + 0.25L * x * y - z;
    std::vector<long double> hits = FindRealRoots({ value, slope, squares }, -10, 10);
    std::erase_if(hits,
      [&](long double t) { return std::fabs(x + t * a) > 0.9L || std::fabs(y + t * b) > 0.8L; });
    return hits;
  };
}

std::vector<SurfaceCut> MakeSurfaceCuts()
{
  const Vec3 centre(0.05, -0.1, 0.1);
  const Vec3 axis = glm::normalize(Vec3(0.6, 0.34, 0.78));
  const Vec3 ball(0.45, 0.3, 0.35);
  const auto boxHits = BoxHits(0.55);
  const auto ballHits = RoundHits(ball, Vec3(0.0), 0.5);
  const auto inBox = [](const LongVec3& x) { return Largest(x) < 0.55L; };
  const auto inBall = [ball](const LongVec3& x)
  {
    const LongVec3 y = Minus(x, ToLong(ball));
    return Dot(y, y) < 0.25L;
  };
  const auto triangles = Ball(2, centre, 0.75);
  return { { "torus", std::make_shared<Torus>(centre, axis, 0.55, 0.25),
             TorusHits(centre, axis, 0.55, 0.25), 0.004 },
    { "box", std::make_shared<ConvexBody>(MakeBox(Vec3(-0.55), Vec3(0.55))), boxHits, 0.004 },
    { "union",
      std::make_shared<Combined>(std::vector{ MakeCubePart(0.55), MakeBallPart(ball, 0.5) },
        [](const std::vector<bool>& in) { return in[0] || in[1]; }),
      BooleanHits({ boxHits, ballHits }, [=](const LongVec3& x) { return inBox(x) || inBall(x); }),
      0.004 },
    { "difference",
      std::make_shared<Combined>(std::vector{ MakeCubePart(0.55), MakeBallPart(ball, 0.5) },
        [](const std::vector<bool>& in) { return in[0] && !in[1]; }),
      BooleanHits({ boxHits, ballHits }, [=](const LongVec3& x) { return inBox(x) && !inBall(x); }),
      0.004 },
    { "disc", std::make_shared<Disc>(centre, axis, 0.8), DiscHits(centre, axis, 0.8), 0.004 },
    { "triangles", std::make_shared<Triangles>(triangles), TriangleHits(triangles), 0.004 },
    { "patches", std::make_shared<BezierPatches>(Saddle()), SaddleHits(), 0.004 } };
}

/// Several a pixel.
std::vector<double> Dense()
{
  std::vector<double> values;
  for (int k = -1000; k <= 1000; ++k)
  {
    values.push_back(0.002 * k + 0.0003);
  }
  return values;
}
const std::vector<double> kDense = Dense();
} // namespace

TEST(ContourSurfaces, NoVerdictIsWrong)
{
  const BentCube cube(std::vector<Shape>(std::begin(kShapes), std::end(kShapes)));
  for (const bool parallel : { false, true })
  {
    const CameraView view = Oblique(parallel);
    for (const SurfaceCut& cut : MakeSurfaceCuts())
    {
      SCOPED_TRACE(::testing::Message() << cut.name << (parallel ? ", parallel" : ""));
      const Sight sight = SightOf(view, kVerdictWidth, kVerdictHeight, cut.hits,
        [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); });
      const TrueVerdicts truth(
        sight, kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
      ContourCertifier certifier({ kContourValues });
      Trace(cube.With(cut.surface), Camera(view, kVerdictWidth, kVerdictHeight),
        { {}, { &certifier } });
      truth.Check(certifier.Verdicts(), false);
      const ContourCounters& counters = certifier.Counters();
      int shown = 0;
      for (int y = 0; y < kVerdictHeight; ++y)
      {
        for (int x = 0; x < kVerdictWidth; ++x)
        {
          shown += sight(x, y) || sight(x + 1, y) || sight(x, y + 1) || sight(x + 1, y + 1) ? 1 : 0;
        }
      }
      std::cout << cut.name << ": " << shown << " pixels, in " << counters.in << ", undecided "
                << counters.undecided << '\n';
      EXPECT_GT(counters.in, 150);
      EXPECT_LE(static_cast<double>(counters.undecided), cut.undecided * shown);
    }
  }
}

/// Silhouettes that rise above a row of corners between two of them, where a contour runs into
/// them: balls moved by parts of a pixel.
TEST(ContourSurfaces, SilhouettesBetweenCornersAreSeen)
{
  const BentCube cube(std::vector<Shape>(std::begin(kShapes), std::end(kShapes)));
  const CameraView view = Oblique(true);
  constexpr double kRadius = 0.06; // some two pixels
  int peeks = 0;
  for (int k = 0; k < 60; ++k)
  {
    const Vec3 centre(0.011 * k, 0.007 * k, -0.005 * k);
    const Sight sight =
      SightOf(view, kVerdictWidth, kVerdictHeight, RoundHits(centre, Vec3(0.0), kRadius),
        [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); });
    const TrueVerdicts truth(sight, kVerdictWidth, kVerdictHeight, kDense, kValueTolerance);
    ContourCertifier certifier({ kDense });
    Trace(cube.With(std::make_shared<Quadric>(MakeSphere(centre, kRadius))),
      Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
    truth.Check(certifier.Verdicts(), false);
    peeks += truth.CountPeeks();
  }
  EXPECT_GT(peeks, 5);
}

/// Every pixel that shows nothing but a plateau of the value is in; none of any other value.
TEST(ContourSurfaces, PlateausAreIn)
{
  const BentCube cube(std::vector<Shape>(std::begin(kShapes), std::end(kShapes)),
    [](const LongVec3& /*x*/, int /*element*/) { return 0.375L; });
  const CameraView view = Oblique(false);
  for (const SurfaceCut& cut : MakeSurfaceCuts())
  {
    SCOPED_TRACE(cut.name);
    ContourCertifier own({ std::vector{ 0.375 } });
    Trace(cube.With(cut.surface), Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &own } });
    const Sight sight = SightOf(view, kVerdictWidth, kVerdictHeight, cut.hits,
      [](const LongVec3& /*x*/, const LongVec3& /*u*/) { return 0.375L; });
    int shown = 0;
    for (int y = 0; y < kVerdictHeight; ++y)
    {
      for (int x = 0; x < kVerdictWidth; ++x)
      {
        const bool all = sight(x, y) && sight(x + 1, y) && sight(x, y + 1) && sight(x + 1, y + 1);
        shown += all ? 1 : 0;
        EXPECT_TRUE(!all ||
          own.Verdicts()[static_cast<std::size_t>(y * kVerdictWidth + x)] ==
            static_cast<std::uint8_t>(ContourVerdict::In))
          << x << " " << y;
      }
    }
    EXPECT_GT(shown, 300);
    ContourCertifier others({ std::vector{ 0.375 - 1e-9, 0.375 + 1e-9 } });
    Trace(cube.With(cut.surface), Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &others } });
    EXPECT_EQ(others.Counters().in, 0);
    EXPECT_LE(static_cast<double>(others.Counters().undecided), cut.undecided * shown);
  }
}
} // namespace pixelexact::testing
