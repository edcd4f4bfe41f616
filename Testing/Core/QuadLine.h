// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "QuadReference.h"

#include "Core/Index/ElementIndex.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

// What a segment crosses in an element, found by marching along it in 113 bits: Newton's iteration
// follows the preimage, sign changes of a function of xi are bisected.
namespace pixelexact::testing
{
using LevelFunction = std::function<Quad(const QuadVec3& xi)>;

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

struct QuadCrossing
{
  double t;
  Vec3 xi;
};

class QuadLine
{
public:
  QuadLine(const Mesh& mesh, int element, const Segment& segment, LevelFunction level)
    : TheMesh(mesh)
    , Element(element)
    , TheSegment(segment)
    , Level(std::move(level))
  {
  }

  /// All sign changes that `steps` steps on either side of a known point show, inside of the shape
  /// or not.
  [[nodiscard]] std::vector<QuadCrossing> March(double known, const Vec3& knownXi, int steps) const
  {
    std::vector<QuadCrossing> found;
    for (const double end : { 0.0, 1.0 })
    {
      auto at =
        Preimage(TheMesh, Element, PointAt(TheSegment, known), { knownXi.x, knownXi.y, knownXi.z });
      double t = known;
      for (int i = 1; at && i <= steps; ++i)
      {
        const double next = i == steps ? end : known + (end - known) * i / steps;
        const auto to = Preimage(TheMesh, Element, PointAt(TheSegment, next), *at);
        if (to && ChangesSign(*at, *to))
        {
          found.push_back(Bisect(t, *at, next));
        }
        at = to;
        t = next;
      }
    }
    return found;
  }

  /// Whether the function changes its sign between two t near to each other, near to xi.
  [[nodiscard]] bool ChangesSign(double from, double to, const Vec3& xi) const
  {
    const QuadVec3 start{ xi.x, xi.y, xi.z };
    const auto a = Preimage(TheMesh, Element, PointAt(TheSegment, from), start);
    const auto b = Preimage(TheMesh, Element, PointAt(TheSegment, to), start);
    return a && b && ChangesSign(*a, *b);
  }

private:
  [[nodiscard]] bool ChangesSign(const QuadVec3& a, const QuadVec3& b) const
  {
    return (Level(a) < Quad(0)) != (Level(b) < Quad(0));
  }

  [[nodiscard]] QuadCrossing Bisect(double t, QuadVec3 xi, double end) const
  {
    for (int step = 0; step < 50; ++step)
    {
      const double middle = 0.5 * (t + end);
      const auto at = Preimage(TheMesh, Element, PointAt(TheSegment, middle), xi);
      if (!at || middle == t || middle == end)
      {
        break;
      }
      if (ChangesSign(xi, *at))
      {
        end = middle;
      }
      else
      {
        t = middle;
        xi = *at;
      }
    }
    return { t,
      { static_cast<double>(xi[0]), static_cast<double>(xi[1]), static_cast<double>(xi[2]) } };
  }

  Mesh TheMesh;
  int Element;
  Segment TheSegment;
  LevelFunction Level;
};
} // namespace pixelexact::testing
