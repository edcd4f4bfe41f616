// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedMeshes.h"
#include "LongMap.h"
#include "TrueVerdicts.h"

#include <algorithm>
#include <array>
#include <cmath>

// A cube of curved elements of any shapes with a field in closed form, and what is seen of it.
namespace pixelexact::testing
{
/// Shapes of the elements of bent cubes.
inline const std::vector<std::vector<Shape>> kMeshShapes{ { Shape::Hexahedron },
  { Shape::Tetrahedron }, { std::begin(kShapes), std::end(kShapes) } };

/// Values of Quadratic whose contours are certified, and the distance from one that counts as none.
inline const std::vector<double> kContourValues{ -2.0, -0.7, -0.1, 0.05, 0.4, 1.1 };
inline constexpr long double kValueTolerance = 1e-11L;

/// A polynomial of degree 2, with saddles on planes and extrema on round surfaces.
inline long double Quadratic(const LongVec3& x)
{
  const auto [a, b, c] = x;
  return 2 * a * a - 3 * b * b + a * b + c * c + 0.5L * a - 0.3L * c;
}

/// The derivatives of Bend, one after the other.
inline std::array<LongVec3, 3> BendColumns(const LongVec3& u)
{
  const auto [a, b, c] = u;
  return { { { 1 - 0.06L * b * c, 0.09L * c - 0.15L * a * a, 0.08L * b + 0.14L * a },
    { 0.22L * b - 0.06L * c * a, 1, 0.08L * a + 0.06L * b * c },
    { 0.05L - 0.06L * a * b, 0.09L * a, 1 + 0.03L * b * b } } };
}

/// The weights of these columns whose sum is r.
inline LongVec3 Weights(const std::array<LongVec3, 3>& columns, const LongVec3& r)
{
  const auto& [a, b, c] = columns;
  const long double determinant = Dot(a, Cross(b, c));
  return Times(1 / determinant, { Dot(r, Cross(b, c)), Dot(r, Cross(c, a)), Dot(r, Cross(a, b)) });
}

/// u of Bend(u) = x, by Newton's iteration; nothing where it does not converge, as it does in the
/// cube.
inline std::optional<LongVec3> Unbent(const LongVec3& x)
{
  LongVec3 u = x;
  for (int step = 0; step < 12; ++step)
  {
    const LongVec3 r = Minus(x, Bend(u));
    if (Largest(r) < 1e-17L)
    {
      return u;
    }
    u = Plus(u, Weights(BendColumns(u), r));
  }
  return std::nullopt;
}

/// A point of the bent cube's boundary on a ray.
struct BoundaryPoint
{
  long double t;
  LongVec3 u;
};

/// The intersection of a ray with the bent face u_axis = side, by Newton's iteration from a u;
/// nothing where it does not converge.
inline std::optional<BoundaryPoint> MeetFace(
  const LongRay& ray, int axis, long double side, const LongVec3& start)
{
  BoundaryPoint point{ Dot(Minus(Bend(start), ray.origin), ray.direction), start };
  point.u[axis] = side;
  for (int step = 0; step < 12; ++step)
  {
    const LongVec3 r = Minus(Plus(ray.origin, Times(point.t, ray.direction)), Bend(point.u));
    if (Largest(r) < 1e-17L * (1 + std::fabs(point.t)))
    {
      return Largest(point.u) <= 1 + 1e-12L ? std::optional(point) : std::nullopt;
    }
    auto columns = BendColumns(point.u);
    columns[axis] = Times(-1, ray.direction);
    LongVec3 by = Weights(columns, r);
    point.t += by[axis];
    by[axis] = 0;
    point.u = Plus(point.u, by);
    if (!(Largest(point.u) < 3))
    {
      break;
    }
  }
  return std::nullopt;
}

/// The first entry of a ray into the bent cube.
inline std::optional<BoundaryPoint> MeetBentCube(const LongRay& ray)
{
  std::optional<BoundaryPoint> nearest;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { -1, 1 })
    {
      // Starts at the intersection with the flat face, and at the middle.
      const long double t = (side - ray.origin[axis]) / ray.direction[axis];
      LongVec3 flat = Plus(ray.origin, Times(t, ray.direction));
      for (long double& one : flat)
      {
        one = std::clamp(one, -1.0L, 1.0L);
      }
      for (const LongVec3& start : { flat, LongVec3{ 0, 0, 0 } })
      {
        const auto point = MeetFace(ray, axis, side, start);
        if (point && point->t > 0 && (!nearest || point->t < nearest->t))
        {
          nearest = point;
        }
      }
    }
  }
  return nearest;
}

/// The bent cube in 2 x 2 x 2 blocks of these shapes, with a field.
class BentCube
{
public:
  using Value = std::function<long double(const LongVec3& x, int element)>;

  explicit BentCube(
    std::span<const Shape> shapes,
    const Value& value = [](const LongVec3& x, int /*element*/) { return Quadratic(x); })
    : Cube(Blocks(2, shapes))
    , locator_(Cube.View())
  {
    Values = FieldOf(value);
    field_ = { "u", Values.View() };
  }

  [[nodiscard]] Scene With(std::shared_ptr<const Surface> surface) const
  {
    return { &locator_, { { std::move(surface), &field_ } }, {} };
  }

  /// Another field on the cube.
  [[nodiscard]] ExpansionBuilder FieldOf(const Value& value) const
  {
    ExpansionBuilder values(1);
    const Mesh mesh = Cube.View();
    LongMap map(mesh);
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      values.Add(UniformSpace(mesh.ShapeOf(e), 6),
        [&](const LongVec3& xi, long double* u) { u[0] = value(map(e, xi), e); });
    }
    return values;
  }

  CurvedMesh Cube;
  Locator locator_;
  ExpansionBuilder Values{ 1 };
  Field field_;
};

/// The true view of the first hits in the bent cube.
inline Sight SightOf(const CameraView& view, int width, int height, const LongHits& hits,
  const std::function<long double(const LongVec3& x, const LongVec3& u)>& value)
{
  return [=](long double px, long double py) -> std::optional<TrueSight>
  {
    const LongRay ray = RayThrough(view, width, height, px, py);
    const std::vector<long double> all = hits(ray);
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const LongVec3 x = Plus(ray.origin, Times(all[k], ray.direction));
      if (all[k] <= 0 || Largest(x) > 1.6L)
      {
        continue;
      }
      const auto u = Unbent(x);
      const long double depth = u ? 1 - Largest(*u) : -1;
      if (std::fabs(depth) < 1e-9L)
      {
        return std::nullopt;
      }
      if (depth > 0)
      {
        return TrueSight{ SheetOf(k, all), value(x, *u) };
      }
    }
    return std::nullopt;
  };
}
} // namespace pixelexact::testing
