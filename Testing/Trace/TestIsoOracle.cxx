// SPDX-License-Identifier: BSD-3-Clause
// Iso-surfaces against the field's own values in 113 bits, and against marching along rays.
#include "CurvedCheck.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Element/Transform.h"
#include "Core/Location/Sample.h"

#include <glm/matrix.hpp>

namespace pixelexact::testing
{
namespace
{
/// A curved element with a field that is given by its coefficients.
struct Element
{
  Element(Shape itsShape, int itsOrder, int itsComponents)
    : shape(itsShape)
    , space(UniformSpace(itsShape, itsOrder))
    , values(itsComponents)
  {
    mesh.Add(UniformSpace(shape, 3), Curved);
    values.Spaces = { space };
    values.SpaceOf = { 0 };
    values.Offset = { 0 };
    values.Coefficients.assign(
      static_cast<std::size_t>(itsComponents) * static_cast<std::size_t>(space.Modes()), 0.0);
    index = std::make_unique<ElementIndex>(mesh.View());
    field = { "f", values.View() };
  }

  [[nodiscard]] std::span<double> Modes(int component)
  {
    const auto modes = static_cast<std::size_t>(space.Modes());
    return std::span(values.Coefficients)
      .subspan(static_cast<std::size_t>(component) * modes, modes);
  }
  void SetNoise(int component, std::uint64_t seed, double scale = 1.0)
  {
    Random random(seed);
    ForEachMode(space,
      [&](int p, int q, int r, int mode)
      {
        Modes(component)[static_cast<std::size_t>(mode)] =
          scale * random() * std::pow(0.8, p + q + r);
      });
  }

  [[nodiscard]] IsoSurface Iso(int component, double value) const
  {
    return { *index, field, component, value };
  }

  [[nodiscard]] Vec3 PointOf(const Vec3& xi) const
  {
    const auto phi = EvaluateQuad(mesh.View().map, 0, { xi.x, xi.y, xi.z });
    return { static_cast<double>(phi[0].value), static_cast<double>(phi[1].value),
      static_cast<double>(phi[2].value) };
  }
  [[nodiscard]] double Value(int component, const Vec3& xi) const
  {
    const auto f = EvaluateQuad(values.View(), 0, { xi.x, xi.y, xi.z });
    if (component != kMagnitude)
    {
      return static_cast<double>(f[static_cast<std::size_t>(component)].value);
    }
    double sum = 0.0;
    for (const QuadValue& one : f)
    {
      sum += static_cast<double>(one.value * one.value);
    }
    return std::sqrt(sum);
  }

  [[nodiscard]] std::vector<Ray> Rays(int count, std::uint64_t seed) const
  {
    Random random(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i)
    {
      rays.push_back(RayThroughPoint(random, PointOf(random.Inside(shape)), random(3.0, 9.0)));
    }
    return rays;
  }

  Shape shape;
  Space space;
  MeshBuilder mesh;
  ExpansionBuilder values;
  std::unique_ptr<ElementIndex> index;
  Field field;
};

struct Statuses
{
  int certain = 0;
  int undecided = 0;
  int raysWithUndecided = 0;
  double off = 0.0;      ///< of the value, largest
  double residual = 0.0; ///< of the place, in the element's size
};

Statuses MeasureHits(
  const Element& one, const Surface& iso, int component, double value, const std::vector<Ray>& rays)
{
  Statuses seen;
  for (const Ray& ray : rays)
  {
    const auto hits = MeetPoints(iso, { ray })[0];
    bool undecided = false;
    for (const PointHit& hit : hits)
    {
      if (hit.status != HitStatus::Certain)
      {
        ++seen.undecided;
        undecided = true;
        continue;
      }
      ++seen.certain;
      seen.off = std::max(seen.off, std::fabs(one.Value(component, hit.point.xi) - value));
      seen.residual =
        std::max(seen.residual, ResidualQuad(one.mesh.View(), ray, hit.t, 0, hit.point.xi));
    }
    seen.raysWithUndecided += undecided ? 1 : 0;
  }
  return seen;
}

void PrintStatuses(const std::string& name, const Statuses& seen)
{
  std::cout << "[ measured ] " << name << ": " << seen.certain << " certain, " << seen.undecided
            << " undecided on " << seen.raysWithUndecided << " rays, value off by " << seen.off
            << ", place by " << seen.residual << "\n";
}
} // namespace

TEST(IsoOracle, MagnitudesAreDecided)
{
  const int count = CurvedRayCount(30);
  for (const Shape shape : kShapes)
  {
    for (const int order : { 2, 5 })
    {
      Element one(shape, order, 3);
      for (int c = 0; c < 3; ++c)
      {
        one.SetNoise(c, 70 + static_cast<std::uint64_t>(c));
      }
      const IsoSurface iso = one.Iso(kMagnitude, 0.9);
      const Statuses seen = MeasureHits(one, iso, kMagnitude, 0.9, one.Rays(count, 71));
      PrintStatuses(std::string(Name(shape)) + " order " + std::to_string(order), seen);
      EXPECT_GT(seen.certain, count / 3);
      EXPECT_LE(seen.raysWithUndecided, 1 + count / 50);
      EXPECT_LE(seen.off, 1e-12);
      EXPECT_LE(seen.residual, 1e-13);
    }
  }
}

/// The values of another component, large, small or NaN, do not affect this one.
TEST(IsoOracle, ComponentsDoNotMindEachOther)
{
  for (const Shape shape : kShapes)
  {
    Element alone(shape, 4, 1);
    alone.SetNoise(0, 80);
    const IsoSurface expected = alone.Iso(0, 0.1);
    const auto rays = alone.Rays(40, 81);
    const auto hits = MeetPoints(expected, rays);
    for (const double scale : { 1e-8, 1e8, 1e20, kNaN })
    {
      Element one(shape, 4, 2);
      one.SetNoise(0, 82, scale);
      one.SetNoise(1, 80);
      const IsoSurface iso = one.Iso(1, 0.1);
      const auto got = MeetPoints(iso, rays);
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        ASSERT_EQ(got[i].size(), hits[i].size())
          << Name(shape) << " beside " << scale << " ray " << i;
        for (std::size_t k = 0; k < hits[i].size(); ++k)
        {
          EXPECT_EQ(got[i][k].t, hits[i][k].t);
        }
      }
    }
  }
}

/// Fields from denormal numbers to almost the largest.
TEST(IsoOracle, FieldsOfAnySize)
{
  Element plain(Shape::Hexahedron, 4, 1);
  plain.SetNoise(0, 83);
  const auto rays = plain.Rays(40, 84);
  const IsoSurface expected = plain.Iso(0, 0.125);
  const auto hits = MeetPoints(expected, rays);
  for (const int exponent : { -1030, -1022, -900, 900, 1020 })
  {
    Element one(Shape::Hexahedron, 4, 1);
    one.SetNoise(0, 83, std::ldexp(1.0, exponent));
    const IsoSurface iso = one.Iso(0, std::ldexp(0.125, exponent));
    const auto got = MeetPoints(iso, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      ASSERT_EQ(got[i].size(), hits[i].size()) << "2^" << exponent << " ray " << i;
      for (std::size_t k = 0; k < hits[i].size(); ++k)
      {
        // Numbers below 2^-1022 have fewer bits.
        EXPECT_NEAR(got[i][k].t, hits[i][k].t, exponent < -1022 ? 1e-9 : 1e-13);
      }
    }
  }
}

/// A field that has the value everywhere has no surface with single hits. The result is undecided,
/// once and quickly.
TEST(IsoOracle, PlateausEnd)
{
  for (const Shape shape : kShapes)
  {
    for (const int components : { 1, 3 })
    {
      for (const int order : { 1, 4, 8 })
      {
        Element one(shape, order, components);
        one.Modes(0)[0] = 0.5;
        const int component = components == 1 ? 0 : kMagnitude;
        const IsoSurface iso = one.Iso(component, one.Value(component, Centre(shape)));
        const auto rays = one.Rays(3, 85);
        double slowest[2] = { 0.0, 0.0 };
        std::size_t most = 0;
        for (double& slow : slowest)
        {
          for (const Ray& ray : rays)
          {
            std::vector<std::vector<PointHit>> hits;
            slow = std::max(slow, Seconds([&] { hits = MeetPoints(iso, { ray }); }));
            most = std::max(most, hits[0].size());
          }
        }
        std::cout << "[ measured ] plateau, " << Name(shape) << " order " << order << ", "
                  << components << " components: " << 1e3 * slowest[0] << " ms, then "
                  << 1e3 * slowest[1] << " ms, " << most << " hits\n";
        EXPECT_LE(most, 4U);
      }
    }
  }
}

namespace
{
/// The field along a ray, followed by Newton's iteration in long double from one of the ray's
/// points in the element: F - value where the preimage is in the shape.
class Along
{
public:
  Along(const Element& one, int component, double value)
    : One(one)
    , mesh_(one.mesh.View())
    , Component(component)
    , Value(value)
  {
  }

  struct Sample
  {
    double t = 0.0;
    double f = 0.0;
    double margin = 0.0; ///< in xi, to the shape's faces
  };

  /// `steps` on either side of t0, whose preimage is known, until well beyond the shape.
  [[nodiscard]] std::vector<Sample> March(
    const Ray& ray, double t0, const Vec3& xi0, int steps) const
  {
    std::vector<Sample> samples;
    for (const double sense : { -1.0, 1.0 })
    {
      Vec3 xi = xi0;
      for (int i = sense > 0.0 ? 0 : 1; i < 4 * steps; ++i)
      {
        const double t = t0 + sense * i / steps;
        if (!Follow(ray.origin + t * ray.direction, xi))
        {
          break;
        }
        const double margin = Margin(One.shape, xi);
        if (margin < -0.1)
        {
          break;
        }
        samples.push_back({ t, F(xi), margin });
      }
      if (sense < 0.0)
      {
        std::ranges::reverse(samples);
      }
    }
    return samples;
  }

private:
  /// Doubles suffice between the roots; the roots are checked in 113 bits.
  [[nodiscard]] bool Follow(const Vec3& x, Vec3& xi) const
  {
    for (int step = 0; step < 20; ++step)
    {
      Vec3 at;
      MapForward(mesh_, 0, std::span(&xi, 1), std::span(&at, 1));
      const auto columns = Jacobians(mesh_, 0, LaneBuffer(std::span(&xi, 1)).View());
      const Vec3 delta = glm::inverse(columns[0]) * (at - x);
      xi -= delta;
      if (glm::length(delta) < 1e-13)
      {
        return true;
      }
      if (!(glm::length(delta) < 1.0))
      {
        return false;
      }
    }
    return false;
  }
  [[nodiscard]] double F(const Vec3& xi) const
  {
    std::vector<double> u(static_cast<std::size_t>(One.field.values.components));
    std::vector<double> by(3 * u.size());
    EvaluateAt(mesh_, One.field, 0, std::span(&xi, 1), u, by);
    if (Component != kMagnitude)
    {
      return u[static_cast<std::size_t>(Component)] - Value;
    }
    double sum = 0.0;
    for (const double one : u)
    {
      sum += one * one;
    }
    return std::sqrt(sum) - Value;
  }

  const Element& One;
  Mesh mesh_;
  int Component;
  double Value;
};
} // namespace

/// The number of roots along a ray is that of marching in steps of 1e-3, where nothing is near a
/// face or a tangent.
TEST(IsoOracle, NumbersOfRootsAreThoseOfMarching)
{
  const int count = CurvedRayCount(12);
  constexpr int kSteps = 1000;
  for (const Shape shape : kShapes)
  {
    for (const int order : { 2, 3, 5, 8 })
    {
      for (const int components : { 1, 2 })
      {
        Element one(shape, order, components);
        for (int c = 0; c < components; ++c)
        {
          one.SetNoise(c, 90 + static_cast<std::uint64_t>(order + c));
        }
        const int component = components == 1 ? 0 : kMagnitude;
        const double value = one.Value(component, Centre(shape));
        const IsoSurface iso = one.Iso(component, value);
        const Along along(one, component, value);
        Random random(91);
        int compared = 0;
        int roots = 0;
        int unsure = 0;
        int undecided = 0;
        int wrong = 0;
        double off = 0.0;
        for (int i = 0; i < count; ++i)
        {
          const Vec3 xi = random.Inside(shape);
          const Ray ray = RayThroughPoint(random, one.PointOf(xi), 5.0);
          const auto samples = along.March(ray, 5.0, xi, kSteps);
          const auto hits = MeetPoints(iso, { ray })[0];
          int changes = 0;
          bool isUnsure = false;
          for (std::size_t k = 1; k < samples.size(); ++k)
          {
            const bool inside = samples[k - 1].margin > 0.0 && samples[k].margin > 0.0;
            const bool isChange = (samples[k - 1].f < 0.0) != (samples[k].f < 0.0);
            changes += inside && isChange ? 1 : 0;
            // Undecided at the face, and near an extremum close to the value.
            isUnsure = isUnsure ||
              ((samples[k - 1].margin > 0.0) != (samples[k].margin > 0.0) &&
                (isChange || std::fabs(samples[k].f) < 0.02)) ||
              (k + 1 < samples.size() && samples[k].margin > -0.01 &&
                (samples[k].f - samples[k - 1].f) * (samples[k + 1].f - samples[k].f) <= 0.0 &&
                std::fabs(samples[k].f) < 1e-4);
          }
          bool isOpen = false;
          for (const PointHit& hit : hits)
          {
            isOpen = isOpen || hit.status == HitStatus::Undecided;
            off = hit.status == HitStatus::Undecided
              ? off
              : std::max(off, std::fabs(one.Value(component, hit.point.xi) - value));
          }
          undecided += isOpen ? 1 : 0;
          if (isUnsure || isOpen || samples.empty())
          {
            ++unsure;
            continue;
          }
          ++compared;
          roots += changes;
          if (static_cast<int>(hits.size()) != changes && ++wrong <= 3)
          {
            ADD_FAILURE() << hits.size() << " hits, " << changes
                          << " changes of sign: " << Name(shape) << " order " << order << ", ray "
                          << i;
          }
        }
        std::cout << "[ measured ] " << Name(shape) << " order " << order << ", " << components
                  << " components: " << compared << " rays with " << roots << " roots, " << unsure
                  << " unsure, " << undecided << " undecided, " << wrong << " wrong; value off by "
                  << off << std::endl;
        EXPECT_GT(compared, count / 2);
        EXPECT_LE(undecided, 1 + count / 50);
        EXPECT_LE(off, 1e-12);
      }
    }
  }
}

/// Sheets close to each other, and a small closed surface inside of one element.
TEST(IsoOracle, ThinSheetsAndSmallSpheres)
{
  for (const double apart : { 1e-3, 1e-4, 1e-6, 1e-9 })
  {
    MeshBuilder mesh;
    mesh.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
    ExpansionBuilder values(1);
    values.Add(UniformSpace(Shape::Hexahedron, 2),
      [](const LongVec3& xi, long double* u) { u[0] = (xi[0] - 0.125L) * (xi[0] - 0.125L); });
    const ElementIndex index(mesh.View());
    const Field field{ "f", values.View() };
    const IsoSurface iso(index, field, 0, 0.25 * apart * apart);
    Random random(95);
    int two = 0;
    int undecided = 0;
    int neither = 0;
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 to(0.125, 0.9 * random(), 0.9 * random());
      const Ray ray = RayTo({ -4.0, random(), random() }, to);
      const auto hits = MeetPoints(iso, { ray })[0];
      const bool isOpen = std::ranges::any_of(
        hits, [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
      const bool isRight = hits.size() == 2 && !isOpen &&
        std::fabs(hits[0].position.x - (0.125 - 0.5 * apart)) <= 1e-9 &&
        std::fabs(hits[1].position.x - (0.125 + 0.5 * apart)) <= 1e-9;
      two += isRight ? 1 : 0;
      undecided += isOpen ? 1 : 0;
      neither += isRight || isOpen ? 0 : 1;
    }
    std::cout << "[ measured ] sheets " << apart << " apart: " << two << " pairs, " << undecided
              << " undecided, " << neither << " neither" << std::endl;
    EXPECT_EQ(neither, 0) << apart;
    if (apart >= 1e-4)
    {
      EXPECT_EQ(two, 200) << apart;
    }
  }
  // 1 - |x - c|^2 = 1 - r^2: a sphere of radius r.
  for (const double radius : { 1e-2, 1e-4 })
  {
    MeshBuilder mesh;
    mesh.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
    ExpansionBuilder values(1);
    values.Add(UniformSpace(Shape::Hexahedron, 2),
      [](const LongVec3& xi, long double* u)
      {
        u[0] = 1.0L;
        for (int d = 0; d < 3; ++d)
        {
          u[0] -=
            (xi[static_cast<std::size_t>(d)] - 0.3L) * (xi[static_cast<std::size_t>(d)] - 0.3L);
        }
      });
    const ElementIndex index(mesh.View());
    const Field field{ "f", values.View() };
    const IsoSurface iso(index, field, 0, 1.0 - radius * radius);
    Random random(96);
    int wrong = 0;
    int undecided = 0;
    for (int i = 0; i < 200; ++i)
    {
      // Half of the rays miss the sphere; none is within a tenth of the radius of a tangent.
      const Vec3 direction = RandomDirection(random);
      const Vec3 aside = glm::normalize(glm::cross(direction, RandomDirection(random)));
      const bool isThrough = i % 2 == 0;
      const double off = radius * (isThrough ? random(0.0, 0.9) : random(1.1, 3.0));
      const Ray ray{ Vec3(0.3) + off * aside - 4.0 * direction, direction };
      const auto hits = MeetPoints(iso, { ray })[0];
      const bool isOpen = std::ranges::any_of(
        hits, [](const PointHit& hit) { return hit.status == HitStatus::Undecided; });
      undecided += isOpen ? 1 : 0;
      wrong += !isOpen && hits.size() != (isThrough ? 2U : 0U) ? 1 : 0;
    }
    std::cout << "[ measured ] sphere of radius " << radius << ": " << wrong << " wrong, "
              << undecided << " undecided" << std::endl;
    EXPECT_EQ(wrong, 0) << radius;
    EXPECT_EQ(undecided, 0) << radius;
  }
}

/// x y z = 0 at its saddle, values at the field's ends, and a surface in the elements' faces.
TEST(IsoOracle, DegenerateValues)
{
  MeshBuilder mesh;
  ExpansionBuilder values(1);
  for (const int side : { -1, 1 })
  {
    mesh.Add(UniformSpace(Shape::Hexahedron, 1),
      [side](const LongVec3& xi) {
        return LongVec3{ (xi[0] + side) / 2, xi[1], xi[2] };
      });
    values.Add(UniformSpace(Shape::Hexahedron, 1),
      [side](const LongVec3& xi, long double* u) { u[0] = (xi[0] + side) / 2; });
  }
  const ElementIndex index(mesh.View());
  const Field field{ "x", values.View() };
  Random random(97);
  // The values are those where the two elements meet, and at the ends of x.
  for (const double value : { 0.0, -1.0, 1.0 })
  {
    const IsoSurface iso(index, field, 0, value);
    for (int i = 0; i < 100; ++i)
    {
      const Ray ray =
        RayTo({ -5.0, random(), random() }, { value, 0.9 * random(), 0.9 * random() });
      const auto hits = MeetPoints(iso, { ray })[0];
      ASSERT_EQ(hits.size(), 1U) << value;
      EXPECT_NEAR(hits[0].position.x, value, 1e-13);
    }
  }
  // The cone x^2 + y^2 - z^2 = 0 and rays through its tip.
  MeshBuilder cube;
  cube.Add(UniformSpace(Shape::Hexahedron, 1), [](const LongVec3& xi) { return xi; });
  ExpansionBuilder cone(1);
  cone.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& xi, long double* u)
    { u[0] = xi[0] * xi[0] + xi[1] * xi[1] - xi[2] * xi[2]; });
  const ElementIndex cubeIndex(cube.View());
  const Field coneField{ "cone", cone.View() };
  const IsoSurface tip(cubeIndex, coneField, 0, 0.0);
  double slowest = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const Vec3 direction = RandomDirection(random);
    std::vector<PointHit> hits;
    const Ray ray{ -4.0 * direction, direction };
    slowest = std::max(slowest, Seconds([&] { hits = MeetPoints(tip, { ray })[0]; }));
    EXPECT_FALSE(hits.empty());
    EXPECT_LE(hits.size(), 3U);
    for (const PointHit& hit : hits)
    {
      EXPECT_LE(glm::length(hit.position), hit.status == HitStatus::Undecided ? 0.1 : 1e-6);
    }
  }
  std::cout << "[ measured ] tip of a cone: " << 1e3 * slowest << " ms at most" << std::endl;
}
} // namespace pixelexact::testing
