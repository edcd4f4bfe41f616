// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the distance of a torus from chords.
#include "Trace/Surfaces/Torus.h"

#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// With rho the distance from the axis and z the height, f of TorusForm is the product of (rho -
/// R)^2 + z^2 - r^2 and (rho + R)^2 + z^2 - r^2. Near the surface, cancellation in it is no larger
/// than the effect of the position's rounding. Lengths are in the form's units, below 1 for points
/// of the torus.
struct TorusPoint
{
  Vec3 y;
  double rho;
  double z;
  double R;
  double r;

  TorusPoint(const Vec3& at, const Vec3& axis, double circle, double tube)
    : y(at)
    , rho(0.0)
    , z(glm::dot(at, axis))
    , R(circle)
    , r(tube)
  {
    rho = glm::length(y - z * axis);
  }

  [[nodiscard]] double Near() const { return (rho - R) * (rho - R) + z * z - r * r; }
  [[nodiscard]] double Far() const { return (rho + R) * (rho + R) + z * z - r * r; }
  /// |y|^2 - R^2 - r^2.
  [[nodiscard]] double Rim() const { return Near() + 2.0 * R * (rho - R); }
  [[nodiscard]] double RimError() const { return NearError() + 2.0 * R * Off(); }
  /// Error of rho and z: some 8 roundings of |y|, and as many of the axis' unit length.
  [[nodiscard]] double Off() const { return 16.0 * kUnitRoundoff * (rho + std::fabs(z) + R); }
  [[nodiscard]] double NearError() const
  {
    return 2.0 * Off() * (std::fabs(rho - R) + std::fabs(z) + r);
  }
  [[nodiscard]] double FarError() const { return 2.0 * Off() * (rho + R + std::fabs(z) + r); }
  /// Upper bound of |f|.
  [[nodiscard]] double Value() const
  {
    return (std::fabs(Near()) + NearError()) * (std::fabs(Far()) + FarError());
  }
};
} // namespace

double Torus::Reach(const Chord& chord) const
{
  const double unit = Form.unit;
  const double R = CircleRadius * unit;
  const double r = TubeRadius * unit;
  const auto point = [&](const Vec3& x)
  { return TorusPoint((x - Form.centre) * unit, Axis, R, r); };
  const TorusPoint a = point(chord.from);
  const TorusPoint b = point(chord.to);
  const TorusPoint middle = point(chord.Middle());
  const Vec3 e = b.y - a.y;
  const double square = glm::dot(e, e);
  const double slack = chord.Slack() * unit;

  // Along the chord f'' = 4 (|y|^2 - R^2 - r^2) |e|^2 + 8 (y.e)^2 + 8 (R z_e)^2, where z_e is e's
  // component along the axis. |y|^2 is convex there, with second derivative 2 |e|^2, and y.e is
  // linear. So |f| is at most the larger of its ends' magnitudes plus an eighth of the largest
  // |f''|.
  const double alongA = glm::dot(a.y, e);
  const double alongB = glm::dot(b.y, e);
  const double rise = R * glm::dot(e, Axis);
  const double lowest = alongA * alongB > 0.0 ? std::min(alongA * alongA, alongB * alongB) : 0.0;
  const double highest = std::max(alongA * alongA, alongB * alongB);
  const double below =
    4.0 * (std::min(a.Rim(), b.Rim()) - 0.25 * square) * square + 8.0 * (lowest + rise * rise);
  const double above = 4.0 * std::max(a.Rim(), b.Rim()) * square + 8.0 * (highest + rise * rise);
  const double bend = std::max(std::fabs(below), std::fabs(above)) +
    64.0 * kUnitRoundoff * (highest + (R * R + r * r) * square);

  // The gradient is 4 Rim y + 8 R^2 z axis, and the second derivatives are 4 Rim + 8 (y y^T + R^2
  // axis axis^T), with z = y.axis. In the ball about the middle:
  const double radius = chord.Radius() * unit;
  const double farthest = glm::length(middle.y) + radius;
  const double rim =
    std::fabs(middle.Rim()) + middle.RimError() + radius * (2.0 * glm::length(middle.y) + radius);
  const double hessian =
    4.0 * rim + 8.0 * (std::max(farthest * farthest, R * R) + R * (std::fabs(middle.z) + radius));
  const Vec3 gradient = 4.0 * middle.Rim() * middle.y + 8.0 * R * R * middle.z * Axis;
  const double error = 4.0 * middle.RimError() * farthest + 8.0 * R * R * middle.Off();
  const double steepest = glm::length(gradient) + error + hessian * radius;
  // The slope along d changes by the second derivatives times d, along the chord and along the ray,
  // and by third derivatives, which are at most 24 |y|.
  const Vec3& d = chord.a.direction;
  const Vec3 turn = 4.0 * middle.Rim() * d + 8.0 * glm::dot(middle.y, d) * middle.y +
    8.0 * R * R * glm::dot(Axis, d) * Axis;
  const double room = chord.Room() * unit;
  const double change = 0.5 * std::fabs(glm::dot(turn, e)) + std::fabs(glm::dot(turn, d)) * room +
    (glm::length(turn) + 4.0 * middle.RimError()) * (slack + (chord.Turn() + 1e-9) * radius) +
    12.0 * farthest * radius * radius;
  // f is in units to the fourth, its slope in units to the third.
  const double value = std::max(a.Value(), b.Value()) + bend / 8.0 + steepest * slack;
  return ReachBySlope(chord, value / unit, glm::dot(gradient, d),
    error + std::min(change, hessian * radius) + steepest * chord.Turn());
}

bool Torus::IsClearOf(const Vec3& centre, double radius) const
{
  // The distances from the circle's nearest and farthest point change by at most the distance of
  // the positions.
  const double R = CircleRadius * Form.unit;
  const double r = TubeRadius * Form.unit;
  const TorusPoint at((centre - Form.centre) * Form.unit, Axis, R, r);
  const double reach = radius * Form.unit + at.Off() +
    8.0 * kUnitRoundoff * Form.unit * (glm::length(centre) + glm::length(Form.centre));
  return std::fabs(std::hypot(at.rho - R, at.z) - r) > reach &&
    std::fabs(std::hypot(at.rho + R, at.z) - r) > reach;
}
} // namespace pixelexact
