// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/Krawczyk.h"
#include "Core/Location/BoxCoefficients.h"
#include "Core/Location/ElementBounds.h"
#include "Core/Math/Interval.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// A box of eta in [-1,1]^3, its ends exact. In xi it is a convex polytope: each end is a plane,
///   eta_d <= b  <=>  1 + xi_d <= (1 + b) s_d(xi),
/// s_d being 1 or the collapsed extent of the shape at xi.
struct EtaBox
{
  Vec3 lower{ -1.0 };
  Vec3 upper{ 1.0 };
};

/// What is known of Phi over a box, for any right-hand side y: made once, asked for many points.
struct InversionNode
{
  EtaBox box;
  /// All values of Phi, in the element's units, widened by the coefficients' errors and by the
  /// element's uncertainty.
  std::array<Interval, 3> hull;
  /// As in ElementBounds, about the box's own centre: every preimage xi in the box of y lies in
  /// xi_0 - [deviation], xi_0 = centre + A^-1 (y - origin).
  bool framed = false;
  Vec3 centre{ 0.0 };
  std::array<double, 3> origin{};
  std::array<double, 9> inverse{}; ///< A^-1, row-major
  std::array<Interval, 3> deviation;
  std::array<double, 3> slack{}; ///< in the deviation, for uncertainty and rounding
  int widest = 0;                ///< the direction of eta along which the deviation varies most

  /// Whether the box may hold a preimage; false is a proof that it holds none.
  [[nodiscard]] bool MightHold(Shape shape, const std::array<double, 3>& y) const;
  /// A guess of the preimage: xi_0, moved into the cube.
  [[nodiscard]] Vec3 Guess(const std::array<double, 3>& y) const;
  /// A^-1 d.
  [[nodiscard]] Vec3 Step(const std::array<double, 3>& d) const;
  /// xi_0.
  [[nodiscard]] Vec3 Root(const std::array<double, 3>& y) const;
  /// Whether the deviation is hardly more than uncertainty and rounding: xi_0 is the root, if there
  /// is one, up to the faces' tolerance, and no smaller box tells more.
  [[nodiscard]] bool IsAffine() const;
  /// Whether the deviation is at most this part of the box: the smaller it is, the likelier is the
  /// map regular on the box, and xi_0 near to the root.
  [[nodiscard]] bool IsNearlyAffine(double part) const;
};

/// Fills in all but the box. `phi`: three functions over the box; `bounds`: of the element.
void MakeFrame(const Space& space, const double* modes, const ElementBounds& bounds,
  const BoxCoefficients& phi, InversionNode& node);

/// Phi at a point, in plain arithmetic.
std::array<double, 3> EvaluateMap(const Space& space, const double* modes, const Vec3& xi);

/// The inverse Jacobian of Phi by xi, [xi][y], in plain arithmetic; nothing where it is singular.
std::optional<SmallMatrix> InverseJacobian(const Space& space, const double* modes, const Vec3& xi);

/// How far a box is taken to reach beyond its ends where its regularity is concerned, in widths.
double ReachOf(const std::array<int, 3>& degree);

/// Whether Phi is injective on the box, reaching beyond its ends by ReachOf (but not beyond a
/// collapsed end): over the convex polytope M times the Jacobian by xi, M about the inverse of its
/// middle, lies in an interval matrix that is strictly diagonally dominant, so that
/// M (Phi(b) - Phi(a)), a mean of that times b - a, vanishes for a = b alone. `slopes`: nine
/// functions d Phi_c / d xi_j over the box, c slowest.
bool IsRegular(const std::array<int, 3>& degree, const BoxCoefficients& slopes);

/// Whether xi lies in the box, with that reach, or beyond it by no more than `tolerance`.
bool Reaches(Shape shape, const EtaBox& box, double reach, const Vec3& xi, double tolerance);
} // namespace pixelexact
