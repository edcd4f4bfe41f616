// SPDX-License-Identifier: BSD-3-Clause
// How far quadrics are off chords.
#include "Trace/Surfaces/Quadric.h"

#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// The largest row sum of Q's magnitudes: no smaller than its norm.
double SizeOf(const QuadraticForm& form)
{
  const auto size = [&](std::size_t k) { return std::fabs(form.Q[k].high); };
  return std::max({ size(0) + size(3) + size(5), size(3) + size(1) + size(4),
           size(5) + size(4) + size(2) }) *
    (1.0 + 1e-14);
}

/// No farther from zero than this f is at a point where half its gradient is h.
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
  // At c = A + s (B - A) on the chord f(c) = -s (1 - s) q(B - A), q the quadratic part, because f
  // vanishes at both ends. Along the ray d through c, f(c + t d) = f(c) + 2 t h.d + t^2 q(d), h
  // half the gradient, has a root with |t| <= |f(c)| / |h.d| where |h.d|^2 >= |f(c)| |q|; as long
  // as that holds it is the one that goes from A to B.
  const Vec3& from = atA.position;
  const Vec3& to = atB.position;
  const Vec3 slopes[2] = { HalfGradient(from), HalfGradient(to) };
  const Vec3 chord = to - from;
  const double largest = SizeOf(Form);
  const double length = std::max(glm::length(slopes[0]), glm::length(slopes[1]));
  const double across = std::fabs(glm::dot(slopes[0], a.direction)) -
    glm::distance(slopes[0], slopes[1]) - length * glm::distance(a.direction, b.direction);
  // q(B - A) is (h(B) - h(A)).(B - A); the hits are off by rounding.
  const double off = 0.25 * std::fabs(glm::dot(slopes[1] - slopes[0], chord)) +
    1e-14 * (length * (glm::length(from) + glm::length(to)) + largest * glm::dot(chord, chord));
  // Written so that a NaN is not known.
  return across > 0.0 && across * across >= 2.0 * off * largest
    ? off / across * (1.0 + 1e-9)
    : std::numeric_limits<double>::infinity();
}

double Quadric::Reach(const Chord& chord) const
{
  // f changes by q(B - A) / 4 from the straight line between its ends' values at most. Half its
  // gradient is linear along the chord, and changes by |Q| times the way beside it.
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
