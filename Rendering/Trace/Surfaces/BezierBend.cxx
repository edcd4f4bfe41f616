// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/BezierBend.h"

#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
/// Width of the margin, in u and v, in which bounds hold.
constexpr double kBeyond = 1.0 / 32.0;
/// Largest distance, in u and v, by which a path may leave the patch: far below visibility, and
/// above the rounding of a path along the patch's edge.
constexpr double kBeside = 1e-10;
constexpr std::size_t kMaxPoints = 17;

/// Control points in rows and columns.
struct Net
{
  int count[2];
  std::vector<Vec3> points;

  [[nodiscard]] Vec3& At(int i, int j)
  {
    return points[static_cast<std::size_t>(i) * static_cast<std::size_t>(count[1]) +
      static_cast<std::size_t>(j)];
  }
  [[nodiscard]] double Largest() const
  {
    double largest = 0.0;
    for (const Vec3& x : points)
    {
      largest = std::max(largest, glm::length(x));
    }
    return largest;
  }
};

/// The same polynomial after the interval [0, 1] of direction d has been extended to [-kBeyond, 1 +
/// kBeyond].
void Stretch(Net& net, int d)
{
  const int n = net.count[d];
  const auto at = [&](int k, int other) -> Vec3&
  { return d == 0 ? net.At(k, other) : net.At(other, k); };
  // De Casteljau's algorithm at the new end gives the control points of the part up to it.
  const auto moveEnd = [&](bool upper, double s)
  {
    for (int other = 0; other < net.count[1 - d]; ++other)
    {
      for (int level = 1; level < n; ++level)
      {
        for (int k = n - 1; k >= level; --k)
        {
          Vec3& to = upper ? at(k, other) : at(n - 1 - k, other);
          const Vec3& before = upper ? at(k - 1, other) : at(n - k, other);
          to = before + s * (to - before);
        }
      }
    }
  };
  moveEnd(true, 1.0 + kBeyond);
  // The interval [0, 1] is now [0, 1 + kBeyond].
  moveEnd(false, 1.0 + kBeyond / (1.0 + kBeyond));
}

/// The control points of the derivative along direction d.
Net Differences(Net net, int d)
{
  const int n = net.count[d] - 1;
  Net by{ { net.count[0], net.count[1] }, {} };
  by.count[d] = std::max(n, 1);
  by.points.resize(
    static_cast<std::size_t>(by.count[0]) * static_cast<std::size_t>(by.count[1]), Vec3(0.0));
  for (int i = 0; n > 0 && i < by.count[0]; ++i)
  {
    for (int j = 0; j < by.count[1]; ++j)
    {
      const Vec3& next = d == 0 ? net.At(i + 1, j) : net.At(i, j + 1);
      by.At(i, j) = n / (1.0 + 2.0 * kBeyond) * (next - net.At(i, j));
    }
  }
  return by;
}

/// Bernstein polynomials of degree n and their first two derivatives.
struct Bernstein
{
  std::array<double, kMaxPoints> of[3]{};

  Bernstein(int n, double s)
  {
    // The loop reaches degrees n - 2, n - 1 and n.
    std::array<double, kMaxPoints> b{};
    b[0] = 1.0;
    for (int degree = 0; degree <= n; ++degree)
    {
      if (degree == n - 2)
      {
        for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i)
        {
          const auto lower = [&](std::size_t less) { return i >= less ? b[i - less] : 0.0; };
          of[2][i] = n * (n - 1) * (lower(2) - 2.0 * lower(1) + lower(0));
        }
      }
      if (degree == n - 1)
      {
        for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i)
        {
          of[1][i] = n * ((i > 0 ? b[i - 1] : 0.0) - b[i]);
        }
      }
      if (degree == n)
      {
        of[0] = b;
        break;
      }
      for (std::size_t i = static_cast<std::size_t>(degree) + 1; i > 0; --i)
      {
        b[i] = (1.0 - s) * b[i] + s * b[i - 1];
      }
      b[0] *= 1.0 - s;
    }
  }
};
} // namespace

BezierBend::BezierBend(const BezierPatch& patch)
  : Degree{ patch.degree[0], patch.degree[1] }
  , Centre(0.0)
  , Points(patch.points)
{
  Vec3 lower = Points[0];
  Vec3 upper = Points[0];
  for (const Vec3& x : Points)
  {
    lower = glm::min(lower, x);
    upper = glm::max(upper, x);
  }
  Centre = 0.5 * lower + 0.5 * upper;
  for (Vec3& x : Points)
  {
    x -= Centre;
  }
  Net net{ { Degree[0] + 1, Degree[1] + 1 }, Points };
  // At sums (n + 1)^2 products of numbers with n roundings each.
  Rounding = 64.0 * kUnitRoundoff * (Degree[0] + Degree[1]) * (net.Largest() + glm::length(Centre));
  Stretch(net, 0);
  Stretch(net, 1);
  const double degree = std::max(Degree[0], Degree[1]);
  const double rounding =
    64.0 * kUnitRoundoff * (Degree[0] + Degree[1]) * 8.0 * degree * degree * degree * net.Largest();
  const auto largest = [&](const Net& of) { return of.Largest() * (1.0 + 1e-12) + rounding; };
  const Net u = Differences(net, 0);
  const Net v = Differences(net, 1);
  const Net uu = Differences(u, 0);
  const Net vv = Differences(v, 1);
  Second[0] = largest(uu);
  Second[1] = largest(Differences(u, 1));
  Second[2] = largest(vv);
  Third[0] = largest(Differences(uu, 0));
  Third[1] = largest(Differences(uu, 1));
  Third[2] = largest(Differences(vv, 0));
  Third[3] = largest(Differences(vv, 1));
}

BezierBend::View BezierBend::At(double u, double v) const
{
  const Bernstein inU(Degree[0], u);
  const Bernstein inV(Degree[1], v);
  View view{ Vec3(0.0), Vec3(0.0), Vec3(0.0), Vec3(0.0), Vec3(0.0), Vec3(0.0) };
  const auto columns = static_cast<std::size_t>(Degree[1]) + 1;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Degree[0]); ++i)
  {
    Vec3 row[3] = { Vec3(0.0), Vec3(0.0), Vec3(0.0) };
    for (std::size_t j = 0; j < columns; ++j)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        row[k] += inV.of[k][j] * Points[i * columns + j];
      }
    }
    view.y += inU.of[0][i] * row[0];
    view.yu += inU.of[1][i] * row[0];
    view.yuu += inU.of[2][i] * row[0];
    view.yv += inU.of[0][i] * row[1];
    view.yuv += inU.of[1][i] * row[1];
    view.yvv += inU.of[0][i] * row[2];
  }
  view.y += Centre;
  return view;
}

/// Paths between two places stay in the patch if their distance from the straight line in (u, v) is
/// at most 4 s (1 - s) times `offU` and `offV`. On the line, 1 - u is (1 - s)(1 - u_A) + s (1 -
/// u_B), and likewise for the other edges.
bool BezierBend::HoldsPaths(const Place& from, const Place& to, double offU, double offV) const
{
  const auto holds = [](double a, double b, double off)
  { return off <= kBeside || (std::max(a, b) >= 4.0 * off && std::min(a, b) >= -kBeside); };
  return holds(from.u, to.u, offU) && holds(1.0 - from.u, 1.0 - to.u, offU) &&
    holds(from.v, to.v, offV) && holds(1.0 - from.v, 1.0 - to.v, offV);
}

double BezierBend::Sagitta(const Chord& chord, const Place& from, const Place& to) const
{
  // The unknowns are (u, v, t) with G = y(u, v) - c(s) - t d(s) = 0, for each point c(s) of the
  // chord and the ray's direction d(s) there. On the straight line in (u, v), with t = 0, G is y's
  // deviation from straightness, s (1 - s) / 2 times a second derivative along the line. With M an
  // approximation of G's derivatives, the map x - M^-1 G contracts by kappa. So there is one root
  // within |M^-1 G| / (1 - kappa). Its distance from the first step -M^-1 G is at most kappa times
  // that (Banach), and it depends continuously on s. Units are those of the chord: h for u and v,
  // its length for t.
  const double du = to.u - from.u;
  const double dv = to.v - from.v;
  const double h = 0.5 * std::max(std::fabs(du), std::fabs(dv));
  const double length = chord.Length();
  const double u = 0.5 * (from.u + to.u);
  const double v = 0.5 * (from.v + to.v);
  // The line, and h around it.
  const double aroundU = 0.5 * std::fabs(du) + h;
  const double aroundV = 0.5 * std::fabs(dv) + h;
  if (!(h > 0.0 && std::fabs(u - 0.5) + aroundU <= 0.5 + kBeyond &&
        std::fabs(v - 0.5) + aroundV <= 0.5 + kBeyond))
  {
    return kInfinity;
  }
  const View middle = At(u, v);
  const double degree = std::max(Degree[0], Degree[1]);
  const double slopeError = Rounding * 2.0 * degree;
  const double bendError = 2.0 * degree * slopeError;
  const double off = Rounding + chord.Slack() +
    std::max(glm::distance(At(from.u, from.v).y, from.position),
      glm::distance(At(to.u, to.v).y, to.position));
  const Vec3 bend = du * du * middle.yuu + 2.0 * du * dv * middle.yuv + dv * dv * middle.yvv;
  const double a = std::fabs(du);
  const double b = std::fabs(dv);
  // Half of the largest change from end to end.
  const double bends = 0.5 *
      (Third[0] * a * a * a + 3.0 * Third[1] * a * a * b + 3.0 * Third[2] * a * b * b +
        Third[3] * b * b * b) +
    bendError * (a + b) * (a + b);
  const double turns = (Second[0] * aroundU + Second[1] * aroundV + slopeError) * h +
    (Second[1] * aroundU + Second[2] * aroundV + slopeError) * h + chord.Turn() * length +
    1e-14 * ((glm::length(middle.yu) + glm::length(middle.yv)) * h + length);

  const Vec3& d = chord.a.direction;
  const Vec3 normal = glm::cross(middle.yu, middle.yv);
  const double volume = glm::dot(normal, d);
  const Vec3 rows[3] = { glm::cross(middle.yv, d) / (volume * h),
    glm::cross(d, middle.yu) / (volume * h), normal / (-volume * length) };
  double step[3];
  double kappa = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double size = glm::length(rows[k]);
    kappa = std::max(kappa, size * turns);
    step[k] = std::fabs(glm::dot(rows[k], bend)) / 8.0 + size * (bends / 8.0 + off);
  }
  const double first = std::max({ step[0], step[1], step[2] });
  const double besides = kappa * first / (1.0 - kappa);
  // The comparison rejects a NaN.
  if (!(kappa <= 0.5 && first + besides <= 1.0 &&
        HoldsPaths(from, to, h * (step[0] + besides), h * (step[1] + besides))))
  {
    return kInfinity;
  }
  return (step[2] + besides) * length * (1.0 + 1e-9);
}
} // namespace pixelexact
