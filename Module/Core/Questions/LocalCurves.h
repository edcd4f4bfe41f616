// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"

namespace pixelexact
{
/// Bounds the second-order Taylor remainders of a node's map and component about one of its xi.
/// They are sharper than bounds from the node's largest second derivatives, because the second
/// derivatives there, and their changes, are known. With d = xi - at, for any xi of EdgeNode::wide,
///
///   M (Phi(xi) - Phi(at) - Phi'(at) d) = 1/2 (B + b) d d,    |b| <= LocalCurves::bends,
///   F(xi) - F(at) - F'(at) d = 1/2 (C + c) d d,              |c| <= LocalCurves::curves,
///
/// where |d| <= away. Mixed terms count twice.
class LocalCurves
{
public:
  /// `node` must have slopes.
  LocalCurves(const EdgeNode& node, const Vec3& at);

  /// Sets `bends` and `curves`, the bounds over |d| <= away.
  void Reach(const std::array<double, 3>& away);

  double bend[3][6]{};  ///< B
  double curve[6]{};    ///< C
  double bends[3][6]{}; ///< b
  double curves[6]{};   ///< c

private:
  const EdgeNode::Slopes& Slopes;
};

/// Bounds the same remainders for the inverse of the map, where the map's Jacobian J is known:
///
///   xi - at - J^-1 (Phi(xi) - Phi(at)) = off,
///   F(xi) - F(at) - F'(at) J^-1 (Phi(xi) - Phi(at)) = curved,
///
/// without the part that the second derivatives of the map and of the component have in common.
class LocalExpansion
{
public:
  /// `node` must have slopes. `slopeError`: of the view's Jacobian.
  LocalExpansion(const EdgeNode& node, const EdgeFunctions::View& view, double slopeError);

  /// False where J is nearly singular. The other functions must not be called then.
  [[nodiscard]] bool IsKnown() const { return Known; }
  /// Bounds `off` where |xi - at| <= away.
  void Off(const double (&away)[3], double (&off)[3]);
  /// Bounds `curved` there. `slope`: F'(at), each with an error of at most `error`.
  [[nodiscard]] double Curved(const double (&away)[3], const Vec3& slope, double error);

private:
  LocalCurves Curves;
  double Inverse[3][3]{}; ///< of M J
  double Turn[3]{};       ///< row sums of Inverse M J - I
  double Bend[3][6]{};    ///< Inverse B
  bool Known = true;
};
} // namespace pixelexact
