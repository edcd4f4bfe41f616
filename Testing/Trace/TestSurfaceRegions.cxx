// SPDX-License-Identifier: BSD-3-Clause
// Whether surfaces may meet flat polygons, against points of them in closed form.
#include "BentCube.h"
#include "CurvedCheck.h"

#include "Trace/Surfaces/Combined.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"

#include <array>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// A point of a surface, and a point with at least a given distance from the whole surface.
using PointOf = std::function<Vec3(Random& random)>;
using PointBeside = std::function<Vec3(double away, Random& random)>;

/// A strip about a point, which lies in its inside: long in one direction, seldom as much across.
Outline StripAbout(const Vec3& x, double length, Random& random)
{
  const Vec3 along = 0.5 * length * RandomDirection(random);
  const Vec3 across = std::pow(10.0, random(-6.0, 0.0)) * 0.5 * length * RandomDirection(random);
  const Vec3 start = x - random(0.1, 1.9) * along - random(0.1, 1.9) * across;
  return Outline(
    std::array{ start, start + 2.0 * along, start + 2.0 * (along + across), start + 2.0 * across });
}

/// `clear`: the least number of strips, among those that miss the surface by their own length, that
/// are proven to miss it.
void CheckStrips(const Surface& surface, const PointOf& on, const PointBeside& beside, double clear)
{
  Random random(29);
  int told = 0;
  constexpr int kStrips = 400;
  for (int k = 0; k < kStrips; ++k)
  {
    const double length = std::pow(10.0, random(-5.0, -0.5));
    EXPECT_TRUE(surface.MayMeet(StripAbout(on(random), length, random), 1e-14, nullptr));
    const double away = std::pow(10.0, random(-4.0, -1.0));
    // No corner is farther from the point than four times a side.
    const Outline missing = StripAbout(beside(away, random), 0.12 * away, random);
    told += surface.MayMeet(missing, 1e-14, nullptr) ? 0 : 1;
  }
  std::cout << told << " of " << kStrips << " told\n";
  EXPECT_GE(told, clear * kStrips);
}

PointOf OnBall(const Vec3& centre, double radius)
{
  return [=](Random& random) { return centre + radius * RandomDirection(random); };
}

PointBeside BesideBall(const Vec3& centre, double radius)
{
  return [=](double away, Random& random)
  { return centre + (radius + (random() < 0.0 ? -away : away)) * RandomDirection(random); };
}
} // namespace

TEST(SurfaceRegions, OfFacesHoldClosedForm)
{
  for (const auto& shapes : kMeshShapes)
  {
    SCOPED_TRACE(Name(shapes.front()));
    const BentCube cube(shapes);
    const ElementIndex& index = cube.locator_.Index();
    const ElementFaces surface(index, BoundaryOf(index));
    const auto at = [](long double depth, Random& random)
    {
      LongVec3 u{ random(), random(), random() };
      const int axis = std::min(2, static_cast<int>(random(0.0, 3.0)));
      for (long double& one : u)
      {
        one *= depth;
      }
      u[axis] = random() < 0.0 ? -depth : depth;
      return ToDouble(Bend(u));
    };
    CheckStrips(
      surface, [&](Random& random) { return at(1.0L, random); },
      // The map shrinks no length to less than half.
      [&](double away, Random& random)
      { return at(1.0L + (random() < 0.0 ? -2 : 2) * static_cast<long double>(away), random); },
      0.9);
  }
}

TEST(SurfaceRegions, OfIsoSurfacesHoldClosedForm)
{
  for (const auto& shapes : kMeshShapes)
  {
    SCOPED_TRACE(Name(shapes.front()));
    const BentCube cube(shapes);
    const ExpansionBuilder values =
      cube.FieldOf([](const LongVec3& x, int /*element*/) { return Dot(x, x); });
    const Field field{ "square", values.View() };
    constexpr double kRadius = 0.75;
    const IsoSurface surface(cube.locator_.Index(), field, 0, kRadius * kRadius);
    CheckStrips(surface, OnBall(Vec3(0.0), kRadius), BesideBall(Vec3(0.0), kRadius), 0.9);
  }
}

TEST(SurfaceRegions, OfBodiesHoldClosedForm)
{
  const Vec3 centre(0.1, -0.2, 0.3);
  const auto ball = std::make_shared<Quadric>(MakeSphere(centre, 0.7));
  CheckStrips(*ball, OnBall(centre, 0.7), BesideBall(centre, 0.7), 0.9);
  const auto inside = [=](const Vec3& x) { return glm::distance(x, centre) - 0.7; };
  const Combined both({ { ball, inside } }, [](const std::vector<bool>& in) { return in[0]; });
  CheckStrips(both, OnBall(centre, 0.7), BesideBall(centre, 0.7), 0.9);
  // About z: a circle of 0.6 and a tube of 0.2.
  const auto onTorus = [=](double radius, Random& random)
  {
    const double turn = random(0.0, 6.28);
    const double about = random(0.0, 6.28);
    const double rho = 0.6 + radius * std::cos(about);
    return centre + Vec3(rho * std::cos(turn), rho * std::sin(turn), radius * std::sin(about));
  };
  CheckStrips(
    Torus(centre, Vec3(0.0, 0.0, 1.0), 0.6, 0.2),
    [&](Random& random) { return onTorus(0.2, random); },
    [&](double away, Random& random)
    { return onTorus(0.2 + (random() < 0.0 ? -away : away), random); },
    0.9);
}
} // namespace pixelexact::testing
