// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedMeshes.h"
#include "LongMap.h"
#include "TrueVerdicts.h"

#include <array>

// A cube of curved elements of any shapes with a field in closed form, and what is seen of it.
namespace pixelexact::testing
{
/// Of degree 2, with saddles on planes and extrema on round surfaces.
inline long double Quadratic(const LongVec3& x)
{
  const auto [a, b, c] = x;
  return 2 * a * a - 3 * b * b + a * b + c * c + 0.5L * a - 0.3L * c;
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
    const auto [a, b, c] = u;
    const std::array<LongVec3, 3> J{
      { { 1 - 0.06L * b * c, 0.09L * c - 0.15L * a * a, 0.08L * b + 0.14L * a },
        { 0.22L * b - 0.06L * c * a, 1, 0.08L * a + 0.06L * b * c },
        { 0.05L - 0.06L * a * b, 0.09L * a, 1 + 0.03L * b * b } }
    };
    const long double determinant = Dot(J[0], Cross(J[1], J[2]));
    u = Plus(u,
      Times(1 / determinant,
        { Dot(r, Cross(J[1], J[2])), Dot(r, Cross(J[2], J[0])), Dot(r, Cross(J[0], J[1])) }));
  }
  return std::nullopt;
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
    , TheLocator(Cube.View())
  {
    const Mesh mesh = Cube.View();
    LongMap map(mesh);
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      Values.Add(UniformSpace(mesh.ShapeOf(e), 6),
        [&](const LongVec3& xi, long double* u) { u[0] = value(map(e, xi), e); });
    }
    TheField = { "u", Values.View() };
  }

  [[nodiscard]] Scene With(std::shared_ptr<const Surface> surface) const
  {
    return { &TheLocator, { { std::move(surface), &TheField } }, {} };
  }

  CurvedMesh Cube;
  Locator TheLocator;
  ExpansionBuilder Values{ 1 };
  Field TheField;
};

/// Of what the first hits in the bent cube show.
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
