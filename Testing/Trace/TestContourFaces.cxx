// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on faces and iso-surfaces against many samples of closed forms.
#include "BentCube.h"
#include "CurvedCheck.h"

#include "Trace/TileVisit.h"

#include <algorithm>
#include <limits>

namespace pixelexact::testing
{
namespace
{
/// Shows all of the cube.
CameraView FromAfar(bool parallel)
{
  CameraView view = Oblique(parallel);
  view.position = { 1.9, -2.9, 6.0 };
  view.parallelScale = 1.9;
  return view;
}

ContourCounters ClassifyAndCheck(
  const Scene& scene, const CameraView& view, const TrueVerdicts& truth)
{
  ContourCertifier certifier({ kContourValues });
  Trace(scene, Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
  truth.Check(certifier.Verdicts(), false);
  const ContourCounters& counters = certifier.Counters();
  std::cout << counters.in << " in, " << counters.undecided << " undecided\n";
  EXPECT_GT(counters.in, 150);
  return counters;
}
} // namespace

namespace
{
/// The number of the bent cube's face at u. In this view one face hides parts of another.
std::size_t FaceOf(const LongVec3& u)
{
  std::size_t face = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    face = std::fabs(u[axis]) == 1 ? 2 * axis + (u[axis] > 0 ? 1 : 0) : face;
  }
  return face;
}
} // namespace

/// The boundary of the bent cube: curved faces, and the edges between them.
TEST(ContourFaces, NoVerdictOnABoundaryIsWrong)
{
  for (const bool parallel : { false, true })
  {
    const CameraView view = FromAfar(parallel);
    const TrueVerdicts truth(
      [&](long double px, long double py) -> std::optional<TrueSight>
      {
        const auto point = MeetBentCube(RayThrough(view, kVerdictWidth, kVerdictHeight, px, py));
        return point ? std::optional(TrueSight{ FaceOf(point->u), Quadratic(Bend(point->u)) })
                     : std::nullopt;
      },
      kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
    for (const auto& shapes : kMeshShapes)
    {
      if (parallel && shapes.size() == 1)
      {
        continue;
      }
      SCOPED_TRACE(::testing::Message()
        << (parallel ? "parallel, " : "") << Name(shapes.front()) << " of " << shapes.size());
      const BentCube cube(shapes);
      const ElementIndex& index = cube.locator_.Index();
      const ContourCounters counters = ClassifyAndCheck(
        cube.With(std::make_shared<ElementFaces>(index, BoundaryOf(index))), view, truth);
      EXPECT_LE(counters.undecided, 2);
    }
  }
}

namespace
{
/// The true view of octants of the bent cube, by the signs of u: each face is a sheet.
std::optional<TrueSight> SeeOctants(const LongRay& ray, std::span<const int> octants)
{
  std::optional<TrueSight> seen;
  long double nearest = std::numeric_limits<long double>::infinity();
  for (const int octant : octants)
  {
    const auto lower = [octant](int axis) { return (octant >> axis & 1) != 0 ? 0.0L : -1.0L; };
    const LongVec3 middle = Bend({ lower(0) + 0.5L, lower(1) + 0.5L, lower(2) + 0.5L });
    const LongVec3 off = Cross(Minus(middle, ray.origin), ray.direction);
    // All of it is nearer to its middle.
    if (Dot(off, off) > 1.3L * 1.3L)
    {
      continue;
    }
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2;
      const long double side = lower(axis) + face % 2;
      const long double t = (side - ray.origin[axis]) / ray.direction[axis];
      LongVec3 flat = Plus(ray.origin, Times(t, ray.direction));
      for (int k = 0; k < 3; ++k)
      {
        flat[k] = std::clamp(flat[k], lower(k), lower(k) + 1);
      }
      const auto point = MeetFace(ray, axis, side, flat);
      bool isIn = point && point->t > 0 && point->t < nearest;
      for (int k = 0; isIn && k < 3; ++k)
      {
        isIn = point->u[k] >= lower(k) - 1e-12L && point->u[k] <= lower(k) + 1 + 1e-12L;
      }
      if (isIn)
      {
        nearest = point->t;
        seen = { static_cast<std::size_t>(6 * octant + face), Quadratic(Bend(point->u)) };
      }
    }
  }
  return seen;
}
} // namespace

/// Four octants that share only edges: faces in front of others, on which the field has other
/// values. Rays near silhouettes show no value between.
TEST(ContourFaces, SilhouettesBeforeOtherSheetsAreSettled)
{
  const std::vector<int> octants{ 0, 3, 5, 6 };
  const CameraView view = FromAfar(false);
  const TrueVerdicts truth([&](long double px, long double py)
    { return SeeOctants(RayThrough(view, kVerdictWidth, kVerdictHeight, px, py), octants); },
    kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
  const BentCube cube(kMeshShapes.front());
  std::vector<ElementFace> faces;
  for (const int octant : octants)
  {
    for (int face = 0; face < 6; ++face)
    {
      faces.push_back({ octant, face });
    }
  }
  ContourCertifier certifier({ kContourValues });
  Trace(cube.With(std::make_shared<ElementFaces>(cube.locator_.Index(), faces)),
    Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
  truth.Check(certifier.Verdicts(), false);
  const ContourCounters& counters = certifier.Counters();
  std::cout << counters.in << " in, " << counters.undecided << " undecided\n";
  EXPECT_GT(counters.in, 150);
  EXPECT_LE(counters.undecided, 2);
}

/// A sphere, as an iso-surface of another field.
TEST(ContourFaces, NoVerdictOnAnIsoSurfaceIsWrong)
{
  constexpr double kRadius = 0.75;
  for (const bool parallel : { false, true })
  {
    const CameraView view = FromAfar(parallel);
    const TrueVerdicts truth(
      SightOf(view, kVerdictWidth, kVerdictHeight, RoundHits(Vec3(0.0), Vec3(0.0), kRadius),
        [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); }),
      kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
    for (const auto& shapes : kMeshShapes)
    {
      if (parallel && shapes.size() == 1)
      {
        continue;
      }
      SCOPED_TRACE(::testing::Message()
        << (parallel ? "parallel, " : "") << Name(shapes.front()) << " of " << shapes.size());
      const BentCube cube(shapes);
      const ExpansionBuilder values =
        cube.FieldOf([](const LongVec3& x, int /*element*/) { return Dot(x, x); });
      const Field field{ "square", values.View() };
      const ContourCounters counters = ClassifyAndCheck(
        cube.With(std::make_shared<IsoSurface>(cube.locator_.Index(), field, 0, kRadius * kRadius)),
        view, truth);
      EXPECT_LE(counters.undecided, 6);
    }
  }
}

namespace
{
/// Checks a scene with one value: pixels that show the surface at a corner are in, few are
/// undecided, and little work is used.
void ExpectInWhereShown(const Scene& scene, double value)
{
  const Camera camera(FromAfar(false), kVerdictWidth, kVerdictHeight);
  ContourCertifier certifier({ std::vector{ value } });
  const Frame frame = Trace(scene, camera, { {}, { &certifier } }, { .corners = Buffer::Verdict });
  const auto shows = [&](int x, int y)
  {
    const auto at = static_cast<std::size_t>(y) * (kVerdictWidth + 1) + static_cast<std::size_t>(x);
    return frame.corners.verdict[at] == static_cast<std::uint8_t>(PixelVerdict::Exact);
  };
  int shown = 0;
  for (int y = 0; y < kVerdictHeight; ++y)
  {
    for (int x = 0; x < kVerdictWidth; ++x)
    {
      const bool any = shows(x, y) || shows(x + 1, y) || shows(x, y + 1) || shows(x + 1, y + 1);
      shown += any ? 1 : 0;
      const auto pixel = static_cast<std::size_t>(y * kVerdictWidth + x);
      const auto verdict = certifier.Verdicts()[pixel];
      EXPECT_TRUE(!any || verdict == static_cast<std::uint8_t>(ContourVerdict::In))
        << x << " " << y;
      const bool all = shows(x, y) && shows(x + 1, y) && shows(x, y + 1) && shows(x + 1, y + 1);
      EXPECT_EQ(certifier.IsOnPlateau(pixel), all) << x << " " << y;
    }
  }
  EXPECT_GT(shown, 300);
  EXPECT_LE(certifier.Counters().undecided, 2);
  EXPECT_EQ(certifier.Counters().spent, 0);
}
} // namespace

/// A wall with a prescribed solution: the field has the value up to rounding there, and differs
/// directly behind.
TEST(ContourFaces, WallsWithTheValueAreIn)
{
  for (const auto& shapes : kMeshShapes)
  {
    SCOPED_TRACE(::testing::Message() << Name(shapes.front()) << " of " << shapes.size());
    const BentCube cube(shapes,
      [](const LongVec3& x, int /*element*/)
      {
        const LongVec3 u = *Unbent(x);
        return (1 - u[0] * u[0]) * (1 - u[1] * u[1]) * (1 - u[2] * u[2]);
      });
    const ElementIndex& index = cube.locator_.Index();
    ExpectInWhereShown(cube.With(std::make_shared<ElementFaces>(index, BoundaryOf(index))), 0.0);
  }
}

/// An iso-surface coloured by its own field has its value everywhere, and no other.
TEST(ContourFaces, AnIsoSurfaceHasItsOwnValueAlone)
{
  constexpr double kValue = 0.3;
  for (const auto& shapes : kMeshShapes)
  {
    SCOPED_TRACE(::testing::Message() << Name(shapes.front()) << " of " << shapes.size());
    const BentCube cube(shapes);
    const Scene scene =
      cube.With(std::make_shared<IsoSurface>(cube.locator_.Index(), cube.field_, 0, kValue));
    ExpectInWhereShown(scene, kValue);
    ContourCertifier others({ std::vector{ kValue - 1e-15, kValue + 1e-15, 1.0 } });
    Trace(scene, Camera(FromAfar(false), kVerdictWidth, kVerdictHeight), { {}, { &others } });
    EXPECT_EQ(others.Counters().in + others.Counters().undecided, 0);
  }
}
} // namespace pixelexact::testing
