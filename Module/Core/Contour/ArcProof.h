// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CurveEquations.h"
#include "Core/Contour/CurvePoint.h"

#include <span>

namespace pixelexact
{
/// Proves that a contour in an element passes given points in their order.
///
/// From one point to the next, a box of eta about both, in which eta_k grows from one to the other,
/// is a tube if, with C near the inverse of the Jacobian of (f, s) by the two other eta,
///   (C (f, s))_i < 0 on the box's lower side i and > 0 on the upper one, for both i, and
///   the Jacobian of C (f, s) is strictly diagonally dominant in the box:
/// each slice eta_k = const then holds one zero (Miranda's theorem) and no other (the mean value
/// theorem), so that the box holds one arc, from end to end. All conditions are checked by hulls of
/// Bernstein coefficients, rounding included. Where that fails, the arc is divided at a point of
/// the contour, and both boxes are tried. A side of the box may lie in a face of the element; there
/// the contour may cross it at the arc's own ends alone.
class ArcProof
{
public:
  /// `crossings`: all points in eta at which contours cross the element's faces.
  ArcProof(const CurveEquations& equations, CurveEvaluator& evaluator, Shape shape, double value,
    std::vector<Vec3> crossings);

  /// Whether the contour leads from each point to the next.
  bool Holds(std::span<const CurvePoint> points);

private:
  bool HoldsBetween(const CurvePoint& from, const CurvePoint& to, int depth);
  [[nodiscard]] bool IsTube(const Vec3& from, const Vec3& to) const;
  [[nodiscard]] bool IsTube(const Vec3& from, const Vec3& to, int along, double room) const;
  [[nodiscard]] bool IsCrossedElsewhere(const Box3& box, const Vec3& from, const Vec3& to) const;

  CurveEvaluator& Evaluator;
  Shape shape_;
  std::vector<Vec3> Crossings;
  BoxPolynomial F; ///< over the whole element
  BoxPolynomial S;
  int Left;
};
} // namespace pixelexact
