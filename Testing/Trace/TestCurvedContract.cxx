// SPDX-License-Identifier: BSD-3-Clause
// What faces, patches and iso-surfaces promise whatever their numbers are: hits that depend on
// their ray alone, the nearest one first, an end to every search.
#include "CurvedCheck.h"

#include "Core/InstructionSets.h"

#include "Trace/Surfaces/BezierPatches.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace pixelexact::testing
{
namespace
{
/// One element with a scalar field of noise, its faces and an iso-surface.
struct Curves
{
  explicit Curves(Shape shape, int order = 5, int components = 1)
    : values(components)
  {
    Random random(7);
    mesh.Add(UniformSpace(shape, 3), Curved);
    const Space space = UniformSpace(shape, order);
    values.Spaces = { space };
    values.SpaceOf = { 0 };
    values.Offset = { 0 };
    for (int c = 0; c < components; ++c)
    {
      ForEachMode(space,
        [&](int p, int q, int r, int)
        { values.Coefficients.push_back(random() * std::pow(0.8, p + q + r)); });
    }
    index = std::make_unique<ElementIndex>(mesh.View());
    field = { "f", values.View() };
    std::vector<ElementFace> all;
    for (int f = 0; f < static_cast<int>(FacesOf(shape).size()); ++f)
    {
      all.push_back({ 0, f });
    }
    faces = std::make_unique<ElementFaces>(*index, all);
    iso = std::make_unique<IsoSurface>(
      *index, field, components > 1 ? kMagnitude : 0, components > 1 ? 0.9 : 0.05);
  }

  [[nodiscard]] Vec3 PointOf(const Vec3& xi) const
  {
    const auto phi = EvaluateQuad(mesh.View().map, 0, { xi.x, xi.y, xi.z });
    return { static_cast<double>(phi[0].value), static_cast<double>(phi[1].value),
      static_cast<double>(phi[2].value) };
  }

  MeshBuilder mesh;
  ExpansionBuilder values;
  std::unique_ptr<ElementIndex> index;
  Field field;
  std::unique_ptr<ElementFaces> faces;
  std::unique_ptr<IsoSurface> iso;
};

std::vector<Ray> MakeRandomRays(const Curves& curves, Shape shape, int count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    rays.push_back(RayThroughPoint(random, curves.PointOf(random.Inside(shape)), random(2.0, 9.0)));
  }
  return rays;
}

void ExpectSamePoints(const PointHit& a, const PointHit& b)
{
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.point.element, b.point.element);
  EXPECT_EQ(a.point.xi, b.point.xi);
  EXPECT_EQ(a.point.piece, b.point.piece);
}

void ExpectSamePoints(
  const std::vector<std::vector<PointHit>>& a, const std::vector<std::vector<PointHit>>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_EQ(a[i].size(), b[i].size()) << "ray " << i;
    for (std::size_t k = 0; k < a[i].size(); ++k)
    {
      ExpectSamePoints(a[i][k], b[i][k]);
    }
  }
}

/// The hits of each ray traced alone.
std::vector<std::vector<PointHit>> OneByOne(
  const Surface& surface, const std::vector<Ray>& rays, bool nearestOnly = false)
{
  std::vector<std::vector<PointHit>> all;
  for (const Ray& ray : rays)
  {
    all.push_back(MeetPoints(surface, { ray }, nearestOnly)[0]);
  }
  return all;
}
} // namespace

/// Rays of one call run in all directions: no frame does this, a module may.
TEST(CurvedContract, HitsDependOnTheirRayAlone)
{
  for (const Shape shape : kShapes)
  {
    for (const int components : { 1, 3 })
    {
      SCOPED_TRACE(Name(shape));
      const Curves curves(shape, 5, components);
      const auto rays = MakeRandomRays(curves, shape, 60, 11);
      ExpectSamePoints(OneByOne(*curves.faces, rays), MeetPoints(*curves.faces, rays));
      ExpectSamePoints(OneByOne(*curves.iso, rays), MeetPoints(*curves.iso, rays));
      // A neighbour from very far away takes nothing and gives nothing.
      auto with = rays;
      with.push_back(RayTo({ 1e9, 2e9, -5e8 }, Vec3(0.1)));
      auto together = MeetPoints(*curves.faces, with);
      together.pop_back();
      ExpectSamePoints(OneByOne(*curves.faces, rays), together);
    }
  }
}

/// Bundles about a diagonal, where one bit decides along which axis a ray runs.
TEST(CurvedContract, HitsOfRaysAboutDiagonals)
{
  const Curves curves(Shape::Hexahedron);
  Random random(12);
  std::vector<Ray> rays;
  for (int i = 0; i < 256; ++i)
  {
    const Vec3 to(0.1 * random(), 0.1 * random(), 0.1 * random());
    const Vec3 along = i % 2 == 0 ? Vec3(1.0, 1.0, 1.0) : Vec3(-1.0, 1.0, 0.2);
    rays.push_back(RayTo(-5.0 * along + to, 0.3 * to + Vec3(0.02)));
  }
  ExpectSamePoints(OneByOne(*curves.faces, rays), MeetPoints(*curves.faces, rays));
  ExpectSamePoints(OneByOne(*curves.iso, rays), MeetPoints(*curves.iso, rays));
}

TEST(CurvedContract, NearestOnlyIsTheFirstOfAll)
{
  for (const Shape shape : kShapes)
  {
    for (const int components : { 1, 3 })
    {
      SCOPED_TRACE(Name(shape));
      const Curves curves(shape, 5, components);
      const auto rays = MakeRandomRays(curves, shape, 60, 13);
      for (const Surface* surface : { static_cast<const Surface*>(curves.faces.get()),
             static_cast<const Surface*>(curves.iso.get()) })
      {
        const auto all = MeetPoints(*surface, rays);
        const auto first = MeetPoints(*surface, rays, true);
        int hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          ASSERT_EQ(all[i].empty(), first[i].empty()) << "ray " << i;
          if (!all[i].empty())
          {
            ++hits;
            ExpectSamePoints(all[i][0], first[i][0]);
          }
        }
        EXPECT_GT(hits, 10);
      }
    }
  }
}

TEST(CurvedContract, InstructionSetsAndThreadsAgree)
{
  for (const Shape shape : kShapes)
  {
    const Curves curves(shape);
    const auto rays = MakeRandomRays(curves, shape, 200, 14);
    const auto faces = MeetPoints(*curves.faces, rays);
    const auto iso = MeetPoints(*curves.iso, rays);
    OnEveryInstructionSet(
      [&]
      {
        const auto other = MeetPoints(*curves.faces, rays);
        const auto otherIso = MeetPoints(*curves.iso, rays);
        ASSERT_EQ(other.size(), faces.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          ASSERT_EQ(other[i].size(), faces[i].size()) << "ray " << i;
          ASSERT_EQ(otherIso[i].size(), iso[i].size()) << "ray " << i;
          for (std::size_t k = 0; k < iso[i].size(); ++k)
          {
            EXPECT_NEAR(otherIso[i][k].t, iso[i][k].t, 1e-10);
          }
        }
      });
    // New surfaces, whose pieces are made by many threads at once.
    const Curves fresh(shape);
    tbb::parallel_for(0, 40,
      [&](int run)
      {
        const auto first = static_cast<std::ptrdiff_t>(5 * run);
        const std::vector<Ray> some(rays.begin() + first, rays.begin() + first + 5);
        const std::vector<std::vector<PointHit>> expected(
          iso.begin() + first, iso.begin() + first + 5);
        ExpectSamePoints(MeetPoints(*fresh.iso, some), expected);
      });
  }
}

TEST(CurvedContract, RaysThatAreNoneMeetNothing)
{
  const Curves curves(Shape::Hexahedron);
  const Vec3 z(0.0, 0.0, 1.0);
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : { kNaN, inf, -inf })
  {
    for (int d = 0; d < 3; ++d)
    {
      Ray from{ -5.0 * z, z };
      from.origin[d] = bad;
      Ray along{ -5.0 * z, z };
      along.direction[d] = bad;
      for (const Ray& ray : { from, along })
      {
        EXPECT_TRUE(MeetPoints(*curves.faces, { ray })[0].empty());
        EXPECT_TRUE(MeetPoints(*curves.iso, { ray })[0].empty());
        // Its neighbours do not mind.
        const auto hits = MeetPoints(*curves.faces, { ray, { -5.0 * z, z } });
        EXPECT_TRUE(hits[0].empty());
        EXPECT_EQ(hits[1].size(), 2U);
      }
    }
  }
  EXPECT_TRUE(MeetPoints(*curves.faces, { { Vec3(0.0), Vec3(0.0) } })[0].empty());
}

/// Zero components, of both signs.
TEST(CurvedContract, RaysAlongAxes)
{
  const Curves curves(Shape::Hexahedron);
  for (int d = 0; d < 3; ++d)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      Vec3 direction(-0.0);
      direction[d] = sign;
      const Ray ray{ -7.0 * direction, direction };
      const auto hits = MeetPoints(*curves.faces, { ray })[0];
      ASSERT_EQ(hits.size(), 2U);
      for (const PointHit& hit : hits)
      {
        EXPECT_LE(
          ResidualQuad(curves.mesh.View(), ray, hit.t, hit.point.element, hit.point.xi), 1e-14);
      }
    }
  }
}

/// Across the ray the errors are bounded by the given numbers; along it t is a double.
TEST(CurvedContract, FromFarAway)
{
  const Curves curves(Shape::Hexahedron);
  Random random(15);
  for (const double away : { 1e2, 1e4, 1e6, 1e8 })
  {
    double across = 0.0;
    int hits = 0;
    for (int i = 0; i < 100; ++i)
    {
      const Ray ray = RayThroughPoint(random, 0.3 * RandomDirection(random), away);
      const auto found = MeetPoints(*curves.faces, { ray })[0];
      for (const PointHit& hit : found)
      {
        ++hits;
        const auto phi = EvaluateQuad(
          curves.mesh.View().map, 0, { hit.point.xi.x, hit.point.xi.y, hit.point.xi.z });
        QuadVec3 to;
        for (int d = 0; d < 3; ++d)
        {
          to[static_cast<std::size_t>(d)] =
            phi[static_cast<std::size_t>(d)].value - Quad(ray.origin[d]);
        }
        for (int d = 0; d < 3; ++d)
        {
          const auto a = static_cast<std::size_t>(d);
          const auto b = (a + 1) % 3;
          const Quad cross =
            to[a] * Quad(ray.direction[(d + 1) % 3]) - to[b] * Quad(ray.direction[d]);
          across = std::max(across, std::fabs(static_cast<double>(cross)));
        }
      }
    }
    EXPECT_GE(hits, 200);
    std::cout << "from " << away << ": off the ray by " << across << "\n";
    EXPECT_LE(across, 1e-13) << "from " << away;
  }
}

/// For faces and iso-surfaces: a ray without a work budget of its own has the hits of one with a
/// budget, up to the first undecided one.
TEST(CurvedContract, NearlyTangentRaysWithoutWorkAreUndecided)
{
  for (const Shape shape : kShapes)
  {
    SCOPED_TRACE(Name(shape));
    const Curves curves(shape);
    for (const Surface* surface : { static_cast<const Surface*>(curves.faces.get()),
           static_cast<const Surface*>(curves.iso.get()) })
    {
      Random random(23);
      std::vector<Ray> rays;
      for (const auto& of : MeetPoints(*surface, MakeRandomRays(curves, shape, 60, 24)))
      {
        for (const PointHit& hit : of)
        {
          const Vec3 normal = surface->Normal(hit.point);
          const Vec3 along = glm::normalize(glm::cross(normal, RandomDirection(random)));
          const Vec3 direction = glm::normalize(along + 1e-7 * random() * normal);
          rays.push_back({ hit.position - 5.0 * direction, direction });
        }
      }
      const std::vector<double> tNear(rays.size(), kNearest);
      const auto all = MeetPoints(*surface, rays, tNear);
      const auto some = MeetPoints(*surface, rays, tNear, false, 0);
      const auto nearest = MeetPoints(*surface, rays, tNear, true, 0);
      int undecided = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        std::size_t k = 0;
        while (k < some[i].size() && some[i][k].status != HitStatus::Undecided)
        {
          ASSERT_LT(k, all[i].size());
          EXPECT_NEAR(some[i][k].t, all[i][k].t, 1e-6) << "ray " << i;
          ++k;
        }
        undecided += k < some[i].size() ? 1 : 0;
        if (k < all[i].size())
        {
          ASSERT_LT(k, some[i].size()) << "ray " << i;
          EXPECT_LE(some[i][k].t, all[i][k].t + 1e-9) << "ray " << i;
        }
        ASSERT_EQ(nearest[i].empty(), some[i].empty());
        if (!some[i].empty())
        {
          ExpectSamePoints(nearest[i][0], some[i][0]);
        }
      }
      EXPECT_GT(undecided, 0);
    }
  }
}

TEST(CurvedContract, RaysFromSoFarThatRoundingMovesThemAreUndecidedAtOnce)
{
  Random random(21);
  for (const Shape shape : kShapes)
  {
    SCOPED_TRACE(Name(shape));
    const Curves curves(shape);
    const Curves near(shape);
    std::vector<Ray> rays;
    for (int i = 0; i < 40; ++i)
    {
      rays.push_back(RayThroughPoint(random, curves.PointOf(random.Inside(shape)), 1e15));
    }
    const std::vector<Ray> others = MakeRandomRays(near, shape, 40, 22);
    std::size_t hits = 0;
    const auto check = [&](const CurvedSurface& far, const CurvedSurface& usual)
    {
      for (const auto& of : MeetPoints(far, rays))
      {
        for (const PointHit& hit : of)
        {
          EXPECT_EQ(hit.status, HitStatus::Undecided);
          ++hits;
        }
      }
      MeetPoints(usual, others);
      EXPECT_LE(far.PiecesMade(), usual.PiecesMade());
    };
    check(*curves.faces, *near.faces);
    check(*curves.iso, *near.iso);
    EXPECT_GT(hits, 0U);
  }
}
} // namespace pixelexact::testing
