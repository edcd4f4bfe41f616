// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"

namespace pixelexact
{
/// Taylor's remainders of second order of a node's map and component about one of its xi: sharper
/// than what the node's largest second derivatives tell, because these are known there, and how
/// they change. With d = xi - at, of any xi of EdgeNode::wide,
///
///   M (Phi(xi) - Phi(at) - Phi'(at) d) = 1/2 (B + b) d d,    |b| <= LocalCurves::bends,
///   F(xi) - F(at) - F'(at) d = 1/2 (C + c) d d,              |c| <= LocalCurves::curves,
///
/// as far off as |d| <= away. Mixed terms count twice.
class LocalCurves
{
public:
  /// `node`: one with slopes.
  LocalCurves(const EdgeNode& node, const Vec3& at);

  /// Bounds what is beside `bend` and `curve` no farther away than this.
  void Reach(const std::array<double, 3>& away);

  double bend[3][6]{};  ///< B
  double curve[6]{};    ///< C
  double bends[3][6]{}; ///< b
  double curves[6]{};   ///< c

private:
  const EdgeNode::Slopes& Slopes;
};

/// The same by xi, where the map's Jacobian J is known, for the way back from the map's values:
///
///   xi - at - J^-1 (Phi(xi) - Phi(at)) = off,
///   F(xi) - F(at) - F'(at) J^-1 (Phi(xi) - Phi(at)) = curved,
///
/// what the map's and the component's curves have in common being left out.
class LocalExpansion
{
public:
  /// `node`: one with slopes. `slopeError`: of the view's Jacobian.
  LocalExpansion(const EdgeNode& node, const EdgeFunctions::View& view, double slopeError);

  /// False where J is nearly singular: nothing else may be asked then.
  [[nodiscard]] bool IsKnown() const { return Known; }
  /// Bounds off where |xi - at| <= away.
  void Off(const double (&away)[3], double (&off)[3]);
  /// Bounds curved there. `slope`: F'(at), each good to `error`.
  [[nodiscard]] double Curved(const double (&away)[3], const Vec3& slope, double error);

private:
  LocalCurves Curves;
  double Inverse[3][3]{}; ///< of M J
  double Turn[3]{};       ///< row sums of Inverse M J - I
  double Bend[3][6]{};    ///< Inverse B
  bool Known = true;
};
} // namespace pixelexact
