// SPDX-License-Identifier: BSD-3-Clause
// Faces of curved elements against all intersections that a dense subdivision and Newton's
// iteration in 113 bits find: none missed, none invented, none twice; closed bodies let nothing in.
#include "CurvedCheck.h"
#include "FacePatch.h"

#include "Core/CurvedMeshes.h"

#include <numeric>
#include <sstream>

namespace pixelexact::testing
{
namespace
{
/// A map of this order on every shape; straight at a pyramid's apex.
MeshBuilder::Map MapOf(Shape shape, int order)
{
  return [=](const LongVec3& xi)
  {
    const auto [a, b, c] = xi;
    const long double size = order == 1 ? 0.0L : 0.04L;
    const LongVec3 bump{ std::pow(b, order), std::pow(c, order), std::pow(a, order) };
    const LongVec3 bent{ a + 0.1L * c * c, b + 0.08L * c * (1 + c) - 0.1L * a, c + 0.05L * b };
    const bool low = order < 3;
    return Plus(low ? xi : shape == Shape::Pyramid ? bent : Curved(xi), Times(size, bump));
  };
}

/// A change of basis for all functions of a hexahedron of order 16 takes a minute; by lines, none.
void AddTo(MeshBuilder& builder, Shape shape, int order)
{
  const Space space = UniformSpace(shape, order);
  const MeshBuilder::Map map = MapOf(shape, order);
  if (shape != Shape::Hexahedron)
  {
    builder.Add(space, map);
    return;
  }
  const auto count = static_cast<std::size_t>(space.Modes());
  std::vector<int> source(count);
  std::iota(source.begin(), source.end(), 0);
  std::vector<std::vector<double>> values(3, std::vector<double>(count));
  const auto n = static_cast<std::size_t>(order + 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto node = [&](std::size_t k)
    { return 2.0L * static_cast<long double>(k % n) / static_cast<long double>(order) - 1.0L; };
    const LongVec3 x = map({ node(i / (n * n)), node(i / n), node(i) });
    for (std::size_t d = 0; d < 3; ++d)
    {
      values[d][i] = static_cast<double>(x[d]);
    }
  }
  const auto change = ChangeOfBasis::Hexahedron(space, Family::EquispacedLagrange, source);
  ExpansionBuilder& phi = builder.Phi;
  phi.Spaces = { space };
  phi.SpaceOf = { 0 };
  phi.Offset = { 0 };
  for (const std::vector<double>& nodes : values)
  {
    std::vector<double> modes(count);
    change.Apply(nodes, 0.0, modes);
    phi.Coefficients.insert(phi.Coefficients.end(), modes.begin(), modes.end());
  }
  builder.Centre = { 0.0, 0.0, 0.0 };
  builder.Size = { 1.0 };
  builder.Uncertainty = { 0.0 };
}

struct FaceTally
{
  int rays = 0;
  int hits = 0;      ///< compared, one with one
  int atEdges = 0;   ///< intersections within 1e-9 of a face's edge
  int grazing = 0;   ///< two within 1e-6 of each other, or a sine of the angle below 1e-6
  int open = 0;      ///< intersections that are neither, and only undecided hits are near
  int undecided = 0; ///< hits
  int wrong = 0;
  double steepest = 0.0; ///< the largest sine at an undecided hit
  double residual = 0.0;
};

void ReportWrongHit(const std::string& what, const Ray& ray, FaceTally& seen)
{
  if (++seen.wrong <= 3)
  {
    ADD_FAILURE() << what << std::hexfloat << "; ray " << ray.origin.x << " " << ray.origin.y << " "
                  << ray.origin.z << " along " << ray.direction.x << " " << ray.direction.y << " "
                  << ray.direction.z;
  }
}

/// Compares a ray's hits with what is on one face.
void CompareHits(const Mesh& mesh, const FacePatch& patch, const Ray& ray,
  const std::vector<PointHit>& hits, FaceTally& seen)
{
  constexpr double kGrazing = 1e-6;
  ++seen.rays;
  std::vector<int> taken(hits.size(), 0);
  std::vector<Vec3> places;
  for (const PointHit& hit : hits)
  {
    places.push_back(hit.point.xi);
  }
  for (const PatchPoint& one : patch.Meet(ray, places))
  {
    const double t = glm::dot(one.position - ray.origin, ray.direction);
    if (t <= 0.0)
    {
      continue; // of the line, behind the ray's origin
    }
    const bool isEdge = one.margin < 1e-9;
    const bool isGrazing = one.sine < kGrazing || one.alone < kGrazing;
    seen.atEdges += isEdge ? 1 : 0;
    seen.grazing += isGrazing ? 1 : 0;
    int certain = 0;
    int undecided = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      const double off = glm::length(hits[i].position - one.position);
      if (hits[i].status == HitStatus::Undecided)
      {
        undecided += off < 0.1 ? 1 : 0;
      }
      else if (off <= 1e-13 / std::max(one.sine, 1e-9) + 1e-12)
      {
        ++certain;
        ++taken[i];
      }
    }
    seen.hits += certain == 1 ? 1 : 0;
    // An undecided interval of a ray is reported once, until a hit is certain.
    const auto last = std::ranges::find_if(
      hits.rbegin(), hits.rend(), [t](const PointHit& hit) { return hit.t < t; });
    const bool isTold = last != hits.rend() && last->status == HitStatus::Undecided;
    const bool isOpen = certain == 0 && (undecided > 0 || isTold);
    seen.open += isOpen && !isEdge && !isGrazing ? 1 : 0;
    if (!isGrazing && !(certain == 1 || isOpen || (isEdge && certain == 0)))
    {
      std::ostringstream what;
      what << certain << " hits for one at margin " << one.margin << ", sine " << one.sine
           << ", the next " << one.alone << " away";
      ReportWrongHit(what.str(), ray, seen);
    }
  }
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const double sine = patch.SineAt(hits[i].point.xi, ray);
    if (hits[i].status == HitStatus::Undecided)
    {
      ++seen.undecided;
      seen.steepest = std::max(seen.steepest, sine);
      continue;
    }
    seen.residual = std::max(
      seen.residual, ResidualQuad(mesh, ray, hits[i].t, hits[i].point.element, hits[i].point.xi));
    if (taken[i] == 0 && patch.MarginOf(hits[i].point.xi) > 1e-9 && sine > kGrazing)
    {
      ReportWrongHit("invented where the sine is " + std::to_string(sine), ray, seen);
    }
  }
}

void PrintFaceTally(const std::string& name, const FaceTally& seen)
{
  std::cout << "[ measured ] " << name << ": " << seen.rays << " rays, " << seen.hits << " hits, "
            << seen.atEdges << " at edges, " << seen.grazing << " grazing, " << seen.open
            << " open; " << seen.undecided << " undecided, of sines up to " << seen.steepest << "; "
            << seen.wrong << " wrong; residual " << seen.residual << std::endl;
}
} // namespace

TEST(FacesOracle, AgainstSubdivision)
{
  Random random(101);
  for (const Shape shape : kShapes)
  {
    for (const int order : { 1, 2, 3, 4, 5, 6, 7, 8, 16 })
    {
      // The full form has all orders.
      const bool isShort = CurvedRayCount(0) == 0 && order != 2 && order != 5;
      if (isShort || (order == 16 && shape != Shape::Hexahedron))
      {
        continue;
      }
      MeshBuilder builder;
      AddTo(builder, shape, order);
      const Mesh mesh = builder.View();
      const ElementIndex index(mesh);
      FaceTally plain;
      FaceTally silhouette;
      const int faces = static_cast<int>(FacesOf(shape).size());
      for (int f = 0; f < faces; ++f)
      {
        const ElementFace face{ 0, f };
        const ElementFaces surface(index, std::span(&face, 1));
        const FacePatch patch(mesh, 0, f);
        const int count = std::max(1, CurvedRayCount(30) / 10);
        std::vector<Ray> rays;
        for (int i = 0; i < count; ++i)
        {
          const Vec3 at = patch.PointAt(random(), random());
          rays.push_back(
            RayThroughPoint(random, at + 1e-2 * RandomDirection(random), random(2.0, 9.0)));
        }
        const auto hits = MeetPoints(surface, rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          CompareHits(mesh, patch, rays[i], hits[i], plain);
        }
        // Tangent to within 1e-1 ... 1e-9.
        rays.clear();
        for (int i = 0; i < count; ++i)
        {
          const double u = random();
          const double v = random();
          const Vec3 at = patch.PointAt(u, v);
          const Vec3 normal = patch.NormalAt(u, v);
          const Vec3 along = glm::normalize(glm::cross(normal, RandomDirection(random)));
          const double small = std::pow(10.0, random(-9.0, -1.0));
          const double off = small * random();
          const Vec3 direction = glm::normalize(along + small * random() * normal);
          rays.push_back({ at + off * small * normal - random(2.0, 4.0) * direction, direction });
        }
        const auto grazing = MeetPoints(surface, rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
        {
          CompareHits(mesh, patch, rays[i], grazing[i], silhouette);
        }
      }
      const std::string name = std::string(Name(shape)) + " order " + std::to_string(order);
      PrintFaceTally(name, plain);
      PrintFaceTally(name + ", silhouettes", silhouette);
      EXPECT_EQ(plain.wrong, 0) << name;
      EXPECT_EQ(silhouette.wrong, 0) << name;
      EXPECT_EQ(plain.undecided, 0) << name;
      EXPECT_LE(plain.residual, 1e-13) << name;
      EXPECT_LE(silhouette.residual, 1e-13) << name;
    }
  }
}

namespace
{
/// Rays from outside meet a closed body an even number of times, and through its middle at least
/// twice.
void ExpectEvenHits(const std::string& name, const Mesh& mesh, Random& random, int count)
{
  const ElementIndex index(mesh);
  const auto faces = BoundaryOf(index);
  const ElementFaces surface(index, faces);
  int odd = 0;
  int slipped = 0;
  int unknown = 0;
  for (int i = 0; i < count; ++i)
  {
    // Targets at vertices, on edges and at random places of the boundary.
    const ElementFace& face =
      faces[static_cast<std::size_t>(random(0.0, 0.999) * static_cast<double>(faces.size()))];
    const FacePatch patch(mesh, face.element, face.face, 0);
    double at[2];
    for (double& u : at)
    {
      const double kind = random();
      u = kind < -0.3 ? -1.0 : kind < 0.3 ? 1.0 : random();
    }
    const Vec3 target = patch.PointAt(at[0], at[1]);
    // Rays from outside through the body's middle or near it, which are not tangent.
    const Vec3 inner(0.2 * random(), 0.2 * random(), 0.2 * random());
    const Vec3 direction = glm::normalize(inner - target);
    const Ray ray{ target - 20.0 * direction, direction };
    const auto hits = MeetPoints(surface, { ray })[0];
    const bool isUnknown = std::ranges::any_of(
      hits, [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
    unknown += isUnknown ? 1 : 0;
    odd += !isUnknown && hits.size() % 2 == 1 ? 1 : 0;
    slipped += hits.empty() || hits[0].t > 20.0 + 1e-9 ? 1 : 0;
    if (!isUnknown && hits.size() % 2 == 1 && odd <= 2)
    {
      for (const PointHit& hit : hits)
      {
        std::cout << std::hexfloat << hit.t << std::defaultfloat << " element " << hit.point.element
                  << " xi " << hit.point.xi.x << " " << hit.point.xi.y << " " << hit.point.xi.z
                  << "\n";
      }
      std::cout << "odd: " << std::hexfloat << ray.origin.x << " " << ray.origin.y << " "
                << ray.origin.z << " along " << ray.direction.x << " " << ray.direction.y << " "
                << ray.direction.z << std::defaultfloat << "\n";
    }
  }
  std::cout << "[ measured ] " << name << ": " << faces.size() << " faces, " << count
            << " rays: " << odd << " odd, " << slipped << " slipped through, " << unknown
            << " undecided" << std::endl;
  EXPECT_EQ(odd, 0) << name;
  EXPECT_EQ(slipped, 0) << name;
  EXPECT_LE(unknown, count / 100) << name;
}
} // namespace

TEST(FacesOracle, ClosedBodiesLetNothingIn)
{
  Random random(102);
  const int count = CurvedRayCount(500);
  for (const Shape shape : kShapes)
  {
    const CurvedMesh mesh = Blocks(2, std::span(&shape, 1));
    ExpectEvenHits(std::string("blocks of ") + Name(shape), mesh.View(), random, count);
  }
  const CurvedMesh all = Hanging(kShapes);
  ExpectEvenHits("hanging, all shapes", all.View(), random, count);
}

/// A cube with flat faces: rays within their planes, along their edges and through its corners.
TEST(FacesOracle, RaysInThePlanesOfFlatFaces)
{
  MeshBuilder builder;
  for (int i = 0; i < 8; ++i)
  {
    builder.Add(UniformSpace(Shape::Hexahedron, 2),
      [i](const LongVec3& xi)
      {
        return LongVec3{ (xi[0] + (i & 1 ? 1 : -1)) / 2, (xi[1] + (i & 2 ? 1 : -1)) / 2,
          (xi[2] + (i & 4 ? 1 : -1)) / 2 };
      });
  }
  const Mesh mesh = builder.View();
  const ElementIndex index(mesh);
  const ElementFaces surface(index, BoundaryOf(index));
  double slowest = 0.0;
  std::size_t most = 0;
  int wrong = 0;
  for (int i = -16; i <= 16; i += 4)
  {
    for (int j = -16; j <= 16; j += 4)
    {
      for (const Vec3& direction : { Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.6, 0.8) })
      {
        const Ray ray{ Vec3(0.0625 * i, 0.0625 * j, 0.0) - 5.0 * direction, direction };
        std::vector<PointHit> hits;
        slowest = std::max(slowest, Seconds([&] { hits = MeetPoints(surface, { ray })[0]; }));
        most = std::max(most, hits.size());
        const bool inPlane = std::abs(i) == 16 || (direction.y == 0.0 && std::abs(j) == 16);
        const bool through = std::abs(i) < 16 && std::abs(j) < 16;
        const bool isUnknown = std::ranges::any_of(
          hits, [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
        if (!inPlane && through && (hits.size() != 2 || isUnknown))
        {
          ++wrong;
        }
      }
    }
  }
  std::cout << "[ measured ] slowest ray " << 1e3 * slowest << " ms, at most " << most << " hits\n";
  EXPECT_EQ(wrong, 0);
  EXPECT_LE(most, 8U);
}
} // namespace pixelexact::testing
