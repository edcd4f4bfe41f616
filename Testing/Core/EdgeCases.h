// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "EnclosureCases.h"
#include "QuadReference.h"
#include "RangeCases.h"

#include "Core/Location/Sample.h"
#include "Core/Questions/EdgeBounds.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

// Elements with fields of noise, their EdgeBounds, and reference values at points.
namespace pixelexact::testing
{
inline const Vec3 kEdgeCaseCentre{ 3.0, -2.0, 1.0 };
inline constexpr double kEdgeCaseSize = 0.25;

inline LongVec3 MapOfAnyOrder(int order, const LongVec3& xi)
{
  const auto [a, b, c] = xi;
  const LongVec3 bump{ b * b * c * c, a * a * c * c, a * a * b * b };
  return Plus(MapOfOrder(order, xi), Times(order < 4 ? 0.0L : 0.03L, bump));
}

/// Pressed flat, across no axis.
inline LongVec3 Flattened(const LongVec3& x, long double flat)
{
  const LongVec3 across{ 2.0L / 3.0L, -1.0L / 3.0L, 2.0L / 3.0L };
  const long double height = across[0] * x[0] + across[1] * x[1] + across[2] * x[2];
  return Plus(x, Times((flat - 1.0L) * height, across));
}

/// The preimage of x near `start`; nothing where Newton's iteration does not converge.
inline std::optional<QuadVec3> Preimage(
  const Mesh& mesh, int element, const QuadVec3& x, QuadVec3 xi)
{
  const auto e = static_cast<std::size_t>(element);
  for (int step = 0; step < 20; ++step)
  {
    const auto phi = EvaluateQuad(mesh.map, element, xi);
    const QuadInverse inverse(phi);
    QuadVec3 r;
    for (std::size_t d = 0; d < 3; ++d)
    {
      r[d] = phi[d].value - (x[d] - Quad(mesh.centre[3 * e + d])) / Quad(mesh.size[e]);
    }
    Quad largest;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const Quad delta = (inverse.Cofactor[0][d] * r[0] + inverse.Cofactor[1][d] * r[1] +
                           inverse.Cofactor[2][d] * r[2]) /
        inverse.Determinant;
      xi[d] = xi[d] - delta;
      largest = largest < Abs(delta) ? Abs(delta) : largest;
    }
    if (largest < Quad(1e-25))
    {
      return xi;
    }
    if (!(largest < Quad(1.0)))
    {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

inline QuadVec3 PointAt(const Segment& segment, const Quad& t)
{
  QuadVec3 x;
  for (int d = 0; d < 3; ++d)
  {
    const Quad from(segment.from[d]);
    x[static_cast<std::size_t>(d)] = from + t * (Quad(segment.to[d]) - from);
  }
  return x;
}

/// An element with a field of noise, and its bounds.
struct EdgeCase : RangeCase
{
  EdgeCase(Shape shape, int mapOrder, int fieldOrder, Random& random, double flat = 1.0)
    : RangeCase(
        UniformSpace(shape, mapOrder),
        [=](const LongVec3& xi)
        {
          return Plus(ToLong(kEdgeCaseCentre),
            Times(kEdgeCaseSize, Flattened(MapOfAnyOrder(mapOrder, xi), flat)));
        },
        kEdgeCaseCentre, kEdgeCaseSize)
    , locator(mesh)
  {
    SetNoise(fieldOrder, random, 0.7);
    Renew();
    Interval sampled(
      std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (int i = 0; i < 300; ++i)
    {
      const double value = ValueAt(random.Inside(shape));
      sampled = { std::min(sampled.lower, value), std::max(sampled.upper, value) };
    }
    range = sampled.upper - sampled.lower;
  }

  /// After a change of the field.
  void Renew()
  {
    bounds = std::make_unique<EdgeBounds>(mesh, locator.Index().BoundsOf(0), 0, field, 0);
  }

  [[nodiscard]] double ValueAt(const Vec3& xi) const
  {
    double value = 0.0;
    EvaluateAt(mesh, field, 0, { &xi, 1 }, { &value, 1 }, {});
    return value;
  }
  [[nodiscard]] Vec3 PointAt(const Vec3& xi) const
  {
    Vec3 x;
    MapForward(mesh, 0, { &xi, 1 }, { &x, 1 });
    return x;
  }
  [[nodiscard]] Quad Truth(const QuadVec3& xi) const
  {
    return EvaluateQuad(field.values, 0, xi)[0].value;
  }

  /// The point as the locator finds it; nothing outside.
  [[nodiscard]] std::optional<LocatedPoint> Located(const Vec3& x) const
  {
    std::int32_t element = -1;
    LocatedPoint point{ x };
    SampleTarget target;
    target.element = { &element, 1 };
    target.xi = { &point.xi, 1 };
    target.value = { &point.value, 1 };
    SampleTile(locator, &field, std::span(&x, 1), target);
    point.eta = ReferenceToTensor(mesh.ShapeOf(0), point.xi);
    return element < 0 ? std::nullopt : std::optional(point);
  }

  Locator locator;
  std::unique_ptr<EdgeBounds> bounds;
  double range = 0.0; ///< of some samples
};

inline Vec3 Direction(Random& random)
{
  return glm::normalize(Vec3(random(), random(), random()));
}

inline QuadVec3 ToQuad(const Vec3& x)
{
  return { x.x, x.y, x.z };
}

/// The distance of a xi from the nearest face, negative outside of the shape.
inline double DepthIn(Shape shape, const QuadVec3& at)
{
  const Vec3 xi(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
  const double low = std::min({ 1.0 + xi.x, 1.0 + xi.y, 1.0 + xi.z });
  switch (shape)
  {
    case Shape::Hexahedron:
      return std::min({ low, 1.0 - xi.x, 1.0 - xi.y, 1.0 - xi.z });
    case Shape::Prism:
      return std::min({ low, -xi.x - xi.z, 1.0 - xi.y });
    case Shape::Tetrahedron:
      return std::min(low, -1.0 - xi.x - xi.y - xi.z);
    default:
      return std::min({ low, -xi.x - xi.z, -xi.y - xi.z });
  }
}

/// Calls check(case, shape, mapOrder, fieldOrder) for elements of every shape and order.
template <class Check>
void ForAllOrders(Random& random, const Check& check)
{
  for (const Shape shape : kShapes)
  {
    for (int mapOrder = 1; mapOrder <= 4; ++mapOrder)
    {
      for (int fieldOrder = 1; fieldOrder <= 8; ++fieldOrder)
      {
        SCOPED_TRACE(::testing::Message()
          << Name(shape) << ", map of order " << mapOrder << ", field of order " << fieldOrder);
        const EdgeCase one(shape, mapOrder, fieldOrder, random);
        check(one);
      }
    }
  }
}

/// The values of a segment's points in the element, from a point known to be there outwards: all
/// that are connected with it.
inline std::vector<Quad> ValuesAlong(
  const EdgeCase& one, const Segment& segment, double known, const Vec3& knownXi, int steps)
{
  const Shape shape = one.mesh.ShapeOf(0);
  std::vector<Quad> values;
  for (const double end : { 0.0, 1.0 })
  {
    std::optional<QuadVec3> at = ToQuad(knownXi);
    for (int i = 0; i <= steps; ++i)
    {
      const Quad t = Quad(known) + (Quad(end) - Quad(known)) * Quad(i) / Quad(steps);
      at = Preimage(one.mesh, 0, PointAt(segment, t), *at);
      if (!at || DepthIn(shape, *at) < 0.0)
      {
        break;
      }
      values.push_back(one.Truth(*at));
    }
  }
  return values;
}
} // namespace pixelexact::testing
