// SPDX-License-Identifier: BSD-3-Clause
// How far faces and iso-surfaces are off chords, against closed forms in long double.
#include "BentCube.h"
#include "CurvedCheck.h"
#include "RayPairs.h"

#include <cmath>
#include <iostream>

namespace pixelexact::testing
{
namespace
{
/// A lower bound of the surface's distance from a segment, along a ray, if the ray meets it there.
using Truth = std::function<double(
  const LongRay& ray, const Vec3& from, const Vec3& to, const SurfacePoint& at)>;

struct SagittaTally
{
  int known = 0;
  int close = 0;
  int closeKnown = 0;
  int crossing = 0; ///< from one element to another
  int crossingKnown = 0;
  int tight = 0; ///< of close ones in an element
  int closeInside = 0;
};

/// A point of the surface at the distance `off` from a plane u_axis = 0 between elements.
using Meeting = std::function<Vec3(int axis, double off, Random& random)>;

/// Pairs from a millionth to a tenth apart, from near and far, some of them across elements.
SagittaTally CheckPairs(
  const Surface& surface, const Truth& truth, const Meeting& meeting, int count)
{
  Random random(83);
  SagittaTally seen;
  for (int k = 0; k < count; ++k)
  {
    const double apart = std::pow(10.0, random(-6.0, -1.0));
    const double away = std::pow(10.0, random(0.6, k % 4 == 0 ? 3.0 : 1.5));
    const bool isAcross = k % 3 == 0;
    const bool isParallel = k % 2 == 0;
    const Pair pair = isAcross
      ? PairTo(meeting(k / 3 % 3, apart * random(), random), random, away, apart, isParallel)
      : Pair(random, away, apart, isParallel);
    const std::vector<Ray> rays{ pair.At(0.0), pair.At(1.0) };
    const auto hits = MeetPoints(surface, rays);
    if (hits[0].empty() || hits[1].empty() ||
      glm::distance(hits[0][0].position, hits[1][0].position) > 16.0 * apart)
    {
      continue;
    }
    const SurfacePoint& from = hits[0][0].point;
    const SurfacePoint& to = hits[1][0].point;
    const double sagitta = surface.Sagitta(rays[0], from, rays[1], to);
    const bool isClose = apart < 1e-3;
    const bool isInside = from.element == to.element;
    const bool isKnown = std::isfinite(sagitta);
    seen.close += isClose ? 1 : 0;
    seen.closeKnown += isClose && isKnown ? 1 : 0;
    seen.crossing += isClose && !isInside ? 1 : 0;
    seen.crossingKnown += isClose && !isInside && isKnown ? 1 : 0;
    if (!isKnown)
    {
      continue;
    }
    ++seen.known;
    double farthest = 0.0;
    for (int i = 1; i < 16; ++i)
    {
      const Ray ray = pair.At(i / 16.0);
      farthest = std::max(farthest,
        truth(
          { ToLong(ray.origin), Unit(ToLong(ray.direction)) }, from.position, to.position, from));
    }
    EXPECT_LE(farthest, sagitta + 1e-14 * away) << "apart " << apart << ", away " << away;
    if (isClose && isInside)
    {
      ++seen.closeInside;
      seen.tight += sagitta <= 4.0 * farthest + 1e-12 * away ? 1 : 0;
    }
  }
  return seen;
}

/// Checks a sphere about the origin.
SagittaTally CheckSphere(const Surface& surface, double radius, int count)
{
  const LongHits sphere = RoundHits(Vec3(0.0), Vec3(0.0), radius);
  return CheckPairs(
    surface,
    [&](const LongRay& ray, const Vec3& from, const Vec3& to, const SurfacePoint& /*at*/)
    {
      double nearest = kNoHit;
      for (const long double t : sphere(ray))
      {
        const Vec3 x = ToDouble(Plus(ray.origin, Times(t, ray.direction)));
        nearest = std::min(nearest, DistanceAlong(from, to, ToDouble(ray.direction), x));
      }
      return nearest;
    },
    [&](int axis, double off, Random& of)
    {
      LongVec3 u{ of(), of(), of() };
      for (int step = 0; step < 40; ++step)
      {
        u[axis] = off;
        const LongVec3 x = Bend(u);
        u = Times(radius / std::sqrt(Dot(x, x)), u);
      }
      return ToDouble(Bend(u));
    },
    count);
}

std::string PrintSagittaTally(const std::vector<Shape>& shapes, const SagittaTally& seen)
{
  const std::string name =
    Name(shapes.front()) + std::string(shapes.size() > 1 ? " and others" : "");
  std::cout << name << ": " << seen.known << " known, of close ones " << seen.closeKnown << " of "
            << seen.close << ", tight " << seen.tight << " of " << seen.closeInside
            << ", of crossing ones " << seen.crossingKnown << " of " << seen.crossing << '\n';
  return name;
}

} // namespace

TEST(CurvedSagitta, OfFacesHoldsClosedForm)
{
  for (const auto& shapes : kMeshShapes)
  {
    const BentCube cube(shapes);
    const ElementIndex& index = cube.locator_.Index();
    const ElementFaces surface(index, BoundaryOf(index));
    const SagittaTally seen = CheckPairs(
      surface,
      [](const LongRay& ray, const Vec3& from, const Vec3& to, const SurfacePoint& at)
      {
        const auto start = Unbent(ToLong(at.position));
        double nearest = kNoHit;
        for (int axis = 0; start && axis < 3; ++axis)
        {
          for (const int side : { -1, 1 })
          {
            const auto point = MeetFace(ray, axis, side, *start);
            nearest = point
              ? std::min(nearest,
                  DistanceAlong(from, to, ToDouble(ray.direction), ToDouble(Bend(point->u))))
              : nearest;
          }
        }
        return nearest;
      },
      [](int axis, double off, Random& of)
      {
        LongVec3 u{ of(), of(), of() };
        u[(axis + 1) % 3] = of() < 0.0 ? -1 : 1;
        u[axis] = off;
        return ToDouble(Bend(u));
      },
      2000);
    SCOPED_TRACE(PrintSagittaTally(shapes, seen));
    EXPECT_GT(seen.known, 700);
    EXPECT_GT(seen.closeKnown, 0.95 * seen.close);
    EXPECT_GT(seen.tight, 0.6 * seen.closeInside);
    EXPECT_GT(seen.crossingKnown, 0.9 * seen.crossing);
  }
}

TEST(CurvedSagitta, OfIsoSurfacesHoldsClosedForm)
{
  for (const auto& shapes : kMeshShapes)
  {
    const BentCube cube(shapes);
    const ExpansionBuilder values =
      cube.FieldOf([](const LongVec3& x, int /*element*/) { return Dot(x, x); });
    const Field field{ "square", values.View() };
    constexpr double kRadius = 0.75;
    const IsoSurface surface(cube.locator_.Index(), field, 0, kRadius * kRadius);
    const SagittaTally seen = CheckSphere(surface, kRadius, 2000);
    SCOPED_TRACE(PrintSagittaTally(shapes, seen));
    EXPECT_GT(seen.known, 400);
    EXPECT_GT(seen.closeKnown, 0.95 * seen.close);
    EXPECT_GT(seen.tight, 0.6 * seen.closeInside);
    EXPECT_GT(seen.crossingKnown, 0.9 * seen.crossing);
  }
}

/// |x|, which is no polynomial.
TEST(CurvedSagitta, OfMagnitudesHoldsClosedForm)
{
  const BentCube cube(kMeshShapes.front());
  const Mesh mesh = cube.Cube.View();
  LongMap map(mesh);
  ExpansionBuilder values(3);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    values.Add(UniformSpace(mesh.ShapeOf(e), 3),
      [&](const LongVec3& xi, long double* u)
      {
        const LongVec3 x = map(e, xi);
        std::copy(x.begin(), x.end(), u);
      });
  }
  const Field field{ "x", values.View() };
  constexpr double kRadius = 0.75;
  const IsoSurface surface(cube.locator_.Index(), field, kMagnitude, kRadius);
  const SagittaTally seen = CheckSphere(surface, kRadius, 600);
  PrintSagittaTally(kMeshShapes.front(), seen);
  EXPECT_GT(seen.closeKnown, 0.9 * seen.close);
}

namespace
{
/// A ball as an iso-surface.
struct IsoBall
{
  static constexpr double kRadius = 0.75;

  BentCube cube{ std::vector<Shape>{ Shape::Hexahedron } };
  ExpansionBuilder values =
    cube.FieldOf([](const LongVec3& x, int /*element*/) { return Dot(x, x); });
  Field field{ "square", values.View() };
  IsoSurface surface{ cube.locator_.Index(), field, 0, kRadius* kRadius };
};
} // namespace

/// Nothing is known between the front and the back, however near to each other they are.
TEST(CurvedSagitta, IsInfiniteAcrossSilhouettes)
{
  const IsoBall ball;
  for (const double beside : { 1e-9, 1e-6, 1e-3, 0.1 })
  {
    const double rim = std::sqrt(IsoBall::kRadius * IsoBall::kRadius - 0.01);
    const Ray ray{ Vec3(rim - beside, 0.1, 5.0), Vec3(0.0, 0.0, -1.0) };
    const auto hits = MeetPoints(ball.surface, { ray })[0];
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_FALSE(std::isfinite(ball.surface.Sagitta(ray, hits[0].point, ray, hits[1].point)));
  }
}

/// The error of a hit is measured: the bound contains it, or is infinite.
TEST(CurvedSagitta, HoldsWhatHitsAreOff)
{
  const IsoBall ball;
  const Ray a{ Vec3(0.1, 0.12, 5.0), Vec3(0.0, 0.0, -1.0) };
  const Ray b{ Vec3(0.101, 0.12, 5.0), Vec3(0.0, 0.0, -1.0) };
  const auto hits = MeetPoints(ball.surface, { a, b });
  const SurfacePoint right = hits[0].front().point;
  const SurfacePoint to = hits[1].front().point;
  ASSERT_LE(ball.surface.Sagitta(a, right, b, to), 1e-6);
  for (const double off : { 1e-9, 1e-6, 1e-4, 1e-2 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      SurfacePoint wrong = right;
      wrong.position[axis] += off;
      EXPECT_GE(ball.surface.Sagitta(a, wrong, b, to), 0.9 * off);
      wrong = right;
      wrong.xi[axis] += off;
      const double sagitta = ball.surface.Sagitta(a, wrong, b, to);
      EXPECT_TRUE(sagitta >= 0.1 * off) << sagitta << " at " << off;
    }
  }
}
} // namespace pixelexact::testing
