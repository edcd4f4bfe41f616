// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourQuestion.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Mat.h"

#include <optional>
#include <vector>

namespace pixelexact
{
/// What is known at a point of an element.
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

  /// Whether the curve has a direction here: it has none at singular points, and where the field's
  /// rounding could part or remove it.
  [[nodiscard]] bool IsRegular() const;
};

/// n . xi = offset: of the plane that makes a point of a curve a root of three equations.
struct CurvePlane
{
  Vec3 normal{ 0.0 };
  double offset = 0.0;
};

/// Evaluates one element, and finds points of its contours by Newton's iteration in xi. Keeps
/// scratch arrays: each thread makes its own.
class CurveEvaluator
{
public:
  CurveEvaluator(const ContourQuestion& question, int element, double value);

  [[nodiscard]] CurvePoint At(const Vec3& xi);
  /// From now on the curve is where along . (grad F x grad s), by xi, vanishes, in place of F -
  /// rho: on a line that the field touches without crossing it both do, and the turn has a slope
  /// there.
  void FollowTurn(const Vec3& along) { Along = along; }
  /// How grad F x grad s, by xi, changes with xi: by differences. Of rank 1 on a touched line, with
  /// the line's direction as image.
  [[nodiscard]] Mat3 TurnByXi(const Vec3& xi);
  /// What the rounding of the field's coefficients can move it by (Plateau.h).
  [[nodiscard]] double Rounding() const { return Digits; }
  /// The point of the contour in the plane, converged to rounding, that Newton's iteration from
  /// `xi` leads to. None where it does not converge, or only farther away than `reach`.
  std::optional<CurvePoint> InPlane(const Vec3& xi, const CurvePlane& plane, double reach);
  /// A point of the contour near `xi`, by steps of least length.
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
