// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourQuestion.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"

#include <optional>
#include <vector>

namespace pixelexact
{
/// Values and derivatives at a point of a contour in an element.
struct CurvePoint
{
  Vec3 xi{ 0.0 };
  Vec3 x{ 0.0 };         ///< world
  double value = 0.0;    ///< of the field
  double residual = 0.0; ///< of the equation beside s = 0: value - rho, or the turn
  Vec3 gradient{ 0.0 };  ///< of the value, world units
  double s = 0.0;        ///< of the cut-surface's function
  Vec3 residualByXi{ 0.0 };
  Vec3 sByXi{ 0.0 };
  Mat3 jacobian{ 0.0 };       ///< d x / d xi
  Vec3 direction{ 0.0 };      ///< of the curve, in xi: the two gradients' product, of length 1
  Vec3 worldDirection{ 0.0 }; ///< of the curve, world units per unit of `direction`

  /// Whether the curve has a direction here. It has none at singular points, and where the rounding
  /// of the field could split or remove it.
  [[nodiscard]] bool IsRegular() const;
};

/// The plane n . xi = offset. With the curve's two equations it determines a point.
struct CurvePlane
{
  Vec3 normal{ 0.0 };
  double offset = 0.0;
};

/// Evaluates one element, and finds points of its contours by Newton's iteration in xi. Keeps
/// scratch arrays: each thread needs its own.
class CurveEvaluator
{
public:
  CurveEvaluator(const ContourQuestion& question, int element, double value);

  [[nodiscard]] CurvePoint At(const Vec3& xi);
  /// From now on the curve is the zero set of along . (grad F x grad s), by xi, in place of F -
  /// rho. On a line that the field touches without crossing it, both vanish, and the turn has a
  /// nonzero slope.
  void FollowTurn(const Vec3& along) { Along = along; }
  /// The derivative of grad F x grad s by xi, from differences. On a touched line it has rank 1,
  /// and its image is the line's direction.
  [[nodiscard]] Mat3 TurnByXi(const Vec3& xi);
  /// Bounds the change of the field by the rounding of its coefficients (Plateau.h).
  [[nodiscard]] double Rounding() const { return Digits; }
  /// The point of the contour in the plane to which Newton's iteration from `xi` converges, to
  /// rounding. None where it does not converge, or only at a distance of more than `reach`.
  std::optional<CurvePoint> InPlane(const Vec3& xi, const CurvePlane& plane, double reach);
  /// A point of the contour near `xi`, by steps of least norm.
  std::optional<CurvePoint> Near(const Vec3& xi, double reach);

private:
  std::optional<CurvePoint> Iterate(const Vec3& xi, const CurvePlane* plane, double reach);
  [[nodiscard]] CurvePoint FieldAt(const Vec3& xi);

  ContourQuestion Question;
  int Element;
  double Value;
  KernelSet MapKernels;
  KernelSet FieldKernels;
  std::vector<double> Lanes;
  double Digits = 0.0;
  double Flattest = 0.0; ///< of |grad F x grad s| over |grad s|, by xi: below it F has no direction
  std::optional<Vec3> Along;
};
} // namespace pixelexact
