// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the distance of quadrics from chords.
#include "Trace/Surfaces/Quadric.h"

#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// The largest row sum of Q's magnitudes, an upper bound of its norm.
double SizeOf(const QuadraticForm& form)
{
  const auto size = [&](std::size_t k) { return std::fabs(form.Q[k].high); };
  return std::max({ size(0) + size(3) + size(5), size(3) + size(1) + size(4),
           size(5) + size(4) + size(2) }) *
    (1.0 + 1e-14);
}

/// Q y, with an error of at most 16 roundoffs of SizeOf times |y|.
Vec3 Turned(const QuadraticForm& form, const Vec3& y)
{
  const double xy = form.Q[3].high;
  const double yz = form.Q[4].high;
  const double xz = form.Q[5].high;
  return { form.Q[0].high * y.x + xy * y.y + xz * y.z, xy * y.x + form.Q[1].high * y.y + yz * y.z,
    xz * y.x + yz * y.y + form.Q[2].high * y.z };
}

/// Lower and upper bound of |f| at a point where half its gradient is h.
struct ValueBounds
{
  double least;
  double most;

  ValueBounds(const QuadraticForm& form, const Vec3& h, const Vec3& position)
  {
    const Vec3 x = position - form.centre;
    const Vec3 b(form.b[0].high, form.b[1].high, form.b[2].high);
    const double value = std::fabs(glm::dot(h + b, x) + form.k.high);
    const double length = glm::length(x);
    const double rounding = 32.0 * kUnitRoundoff *
      ((SizeOf(form) * length + 2.0 * glm::length(b)) * length + std::fabs(form.k.high));
    least = value - rounding;
    most = value + rounding;
  }
};
} // namespace

double Quadric::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  return SagittaAmong(std::array{ a, b }, std::array{ atA.position, atB.position });
}

double Quadric::SagittaOver(const std::array<Ray, 3>& rays, const std::array<Vec3, 3>& hits) const
{
  return SagittaAmong(rays, hits);
}

double Quadric::SagittaAmong(std::span<const Ray> rays, std::span<const Vec3> hits) const
{
  // At c = sum w_i A_i, w_i >= 0 with sum 1, f(c) = -sum_{i<j} w_i w_j q(A_i - A_j), where q is the
  // quadratic part, because f vanishes at all A_i; sum_{i<j} w_i w_j is at most (1 - 1 / n) / 2.
  // Along the ray d through c, f(c + t d) = f(c) + 2 t h.d + t^2 q(d), where h is half the
  // gradient. It has a root with |t| <= |f(c)| / |h.d| if |h.d|^2 >= |f(c)| |q|. While this holds,
  // the root leads continuously from hit to hit.
  const double largest = SizeOf(Form);
  const Vec3 b(Form.b[0].high, Form.b[1].high, Form.b[2].high);
  double way = 0.0;
  double farthest = 0.0;
  for (const Vec3& hit : hits)
  {
    way = std::max(way, glm::length(hit - Form.centre));
    farthest = std::max(farthest, glm::length(hit));
  }
  double turn = 0.0;
  double spread = 0.0;
  double bulge = 0.0;
  double chord = 0.0;
  for (std::size_t i = 1; i < hits.size(); ++i)
  {
    spread = std::max(spread, glm::distance(rays[0].direction, rays[i].direction));
    for (std::size_t j = 0; j < i; ++j)
    {
      // h(A) - h(B) is Q (A - B).
      const Vec3 between = hits[i] - hits[j];
      const Vec3 turned = Turned(Form, between);
      bulge = std::max(bulge, std::fabs(glm::dot(turned, between)));
      chord = std::max(chord, glm::dot(between, between));
      turn = std::max(turn, glm::length(turned));
    }
  }
  // Doubles suffice: on chords that are not tiny, their error of h is far less than h's change.
  const Vec3 slope = Turned(Form, hits[0] - Form.centre) + b;
  const double unsure = 32.0 * kUnitRoundoff * (largest * way + glm::length(b));
  turn += 32.0 * kUnitRoundoff * largest * std::sqrt(chord);
  const double length = glm::length(slope) + turn + unsure;
  const double across =
    std::fabs(glm::dot(slope, rays[0].direction)) - 2.0 * unsure - turn - length * spread;
  // Rounding of the hits.
  const double off = 0.5 * (1.0 - 1.0 / static_cast<double>(hits.size())) * bulge +
    1e-14 * (2.0 * length * farthest + largest * chord);
  // The comparison makes a NaN infinite.
  return across > 0.0 && across * across >= 2.0 * off * largest
    ? off / across * (1.0 + 1e-9)
    : std::numeric_limits<double>::infinity();
}

double Quadric::Reach(const Chord& chord) const
{
  // f differs by at most q(B - A) / 4 from linear interpolation between the chord's ends. Half its
  // gradient is linear along the chord, and changes by at most |Q| times the distance from it.
  const Vec3 slopes[2] = { HalfGradient(chord.from), HalfGradient(chord.to) };
  const double largest = SizeOf(Form);
  const double radius = chord.Radius();
  const double middle = 0.5 * glm::length(slopes[0] + slopes[1]);
  const double steepest = 2.0 * (middle + largest * radius) * (1.0 + 1e-14);
  const double bend = 0.25 * std::fabs(glm::dot(slopes[1] - slopes[0], chord.Along()));
  const double value = std::max(ValueBounds(Form, slopes[0], chord.from).most,
                         ValueBounds(Form, slopes[1], chord.to).most) +
    bend + steepest * (chord.Slack() + 1e-14 * chord.Length());
  return ReachBySlope(chord, value, glm::dot(slopes[0] + slopes[1], chord.a.direction),
    std::fabs(glm::dot(slopes[1] - slopes[0], chord.a.direction)) +
      2.0 * largest * (chord.Room() + chord.Slack()) + steepest * (chord.Turn() + 1e-14));
}

bool Quadric::IsClearOf(const Vec3& centre, double radius) const
{
  const Vec3 slope = HalfGradient(centre);
  const double reach = radius + 16.0 * kUnitRoundoff * glm::length(centre);
  return ValueBounds(Form, slope, centre).least >
    (2.0 * glm::length(slope) + SizeOf(Form) * reach) * reach * (1.0 + 1e-14);
}
} // namespace pixelexact
