// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/ElementBounds.h"
#include "Core/Math/Interval.h"
#include "Core/Tree/BoxCoefficients.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <cstddef>
#include <limits>

namespace pixelexact
{
/// For a hexahedron with more coefficients than this, frames alone prove that the map is regular in
/// a box: the coefficients of the derivatives are three times as many, and another subdivision of
/// the box costs less.
inline constexpr std::size_t kMaxWithSlopes = 9 * 9 * 9;

/// The image of an end of a box in y. All values of Phi over the box have normal . (y - origin) <=
/// outer. The normal is that of the frame, or of the end itself where the box bends too much for
/// the frame. A y with normal . (y - origin) <= inner, for all ends, is a value (Brouwer: xi ->
/// xi_0 - deviation(xi) then takes the box into itself).
struct ImagePlane
{
  std::array<double, 3> normal{};
  double outer = std::numeric_limits<double>::infinity();
  /// The same bound for points that the element's own Newton iteration may still accept: its
  /// tolerance belongs to another Jacobian.
  double wider = std::numeric_limits<double>::infinity();
  double inner = -std::numeric_limits<double>::infinity();
};

/// Bounds of Phi over a box, for any right-hand side y: computed once, used for many points.
struct NodeFrame
{
  EtaBox box;
  /// Encloses all values of Phi, in the element's units, widened by the coefficients' errors and by
  /// the element's uncertainty.
  std::array<Interval, 3> hull;
  /// As in ElementBounds, about the box's own centre: every preimage xi in the box of y lies in
  /// xi_0 - [deviation], xi_0 = centre + A^-1 (y - origin).
  bool framed = false;
  Vec3 centre{ 0.0 };
  std::array<double, 3> origin{};
  std::array<double, 9> inverse{}; ///< A^-1, row-major
  std::array<Interval, 3> deviation;
  std::array<double, 3> slack{}; ///< in the deviation, for uncertainty and rounding
  /// The largest deviation, relative to the box's longest side.
  double bending = std::numeric_limits<double>::infinity();
  /// Whether the frame proves that the map is injective over the box and its reach (ReachOf); for
  /// hexahedra alone.
  bool injective = false;
  /// The six ends of the polytope of a framed box, uncertainty and rounding included.
  std::array<ImagePlane, 6> plane;
  int widest = 0; ///< the direction of eta along which the deviation varies most

  /// A guess of the preimage: xi_0, moved into the cube.
  [[nodiscard]] Vec3 Guess(const Vec3& y) const;
  /// A^-1 d.
  [[nodiscard]] Vec3 Step(const Vec3& d) const;
  /// xi_0.
  [[nodiscard]] Vec3 Root(const Vec3& y) const;
  /// Whether the deviation is hardly more than uncertainty and rounding. Then xi_0 is the root, if
  /// there is one, up to the faces' tolerance, and a smaller box would not improve it.
  [[nodiscard]] bool IsAffine() const;
  /// Whether the deviation is at most this fraction of the box. The smaller it is, the likelier the
  /// map is regular on the box, and the closer xi_0 is to the root.
  [[nodiscard]] bool IsNearlyAffine(double part) const { return bending <= part; }
};

/// Sets everything except `box`. `phi`: three functions over the box; `bounds`: of the element.
void MakeFrame(const Space& space, const double* modes, const ElementBounds& bounds,
  const BoxCoefficients& phi, NodeFrame& frame);

/// A step of Newton's iteration from xi towards y, in plain arithmetic; zero where the Jacobian
/// cannot be inverted.
Vec3 StepOfMap(const Space& space, const double* modes, const Vec3& xi, const Vec3& y);
} // namespace pixelexact
