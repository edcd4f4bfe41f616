// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pixelexact
{
/// Radii of polydiscs about the middle of a box, in half widths of the box.
inline constexpr std::array<double, 8> kDiscRadii{ 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0 };

/// One number for each of kDiscRadii.
using DiscBounds = std::array<double, kDiscRadii.size()>;

/// The inverse of an element's map about the middle c of a box of eta, as an analytic function of
/// complex coordinates
///   z = A^-1 (y - Phi(c)),   s = (eta - c) / half width,   A = d Phi / d s at c,
/// y in the element's units. It states nothing where det A vanishes.
///
/// Proof: in terms of z the map is s + N(s). Sums of the magnitudes of Taylor coefficients bound N
/// and its Lipschitz constant L in the max norm over a polydisc |s| <= R. Where L < 1,
/// s -> z - N(s) is a contraction of the polydisc for every |z| <= R - max |N|, so that it has
/// exactly one fixed point, which is analytic in z.
struct AnalyticInverse
{
  Box3 box{ Vec3(-1.0), Vec3(1.0) }; ///< of eta
  Vec3 centre{ 0.0 };                ///< c
  Vec3 halfWidth{ 1.0 };             ///< of the box, in eta
  std::array<double, 3> elementCentre{};
  double inverseSize = 1.0;        ///< of the element
  std::array<double, 3> origin{};  ///< Phi(c), in the element's units
  std::array<double, 9> inverse{}; ///< A^-1, row-major
  /// Every complex z with max norm <= reach[k] has exactly one s with max norm <= kDiscRadii[k],
  /// and s is analytic in z. At most 0: not proven.
  DiscBounds reach{};

  /// z of a point in world coordinates.
  [[nodiscard]] Vec3 CoordinatesOf(const Vec3& x) const;
  /// The change of z along a vector in world coordinates.
  [[nodiscard]] Vec3 DirectionOf(const Vec3& d) const;
  /// The smallest k with a polydisc of z that holds all of max norm `most`; kDiscRadii.size():
  /// none.
  [[nodiscard]] std::size_t DiscOf(double most) const;
};

/// The inverse about the middle of a box of eta in [-1,1]^3. The map is the stored one, as Mesh has
/// it. `reach` is 0 where a coefficient is not finite or the Jacobian at the middle is singular.
AnalyticInverse MakeAnalyticInverse(const Mesh& mesh, int element, const Box3& box);

/// Bounds |f - f(c)| over the polydiscs |s| <= kDiscRadii[k], c the box's middle, for each
/// component f of an element's function; infinite where a coefficient is not finite.
std::vector<DiscBounds> BoundsOverDiscs(const Expansion& function, int element, const Box3& box);

/// Bounds the distance on [-1, 1] between a function f of s along z(t) = middle + t half and the
/// polynomial that interpolates it in n Chebyshev points (of the first kind), for all z(t) with
/// offsets of max norm |offset_i| added to coordinate i. `bounds`: of |f - f(c)|. Infinite where
/// nothing is proven.
///
/// With M a bound of |f - f(c)| in the ellipse with foci -1 and 1 and half axes summing to rho, the
/// error is at most 4 M rho^(1-n) / (rho - 1) (L. N. Trefethen, Approximation Theory and
/// Approximation Practice, 2013, theorem 8.2). z(t) stays in the polydisc of reach r if
/// |middle_i| + |offset_i| + |half_i| (rho + 1/rho) / 2 <= r.
double InterpolationError(const AnalyticInverse& inverse, const DiscBounds& bounds,
  const Vec3& middle, const Vec3& half, const Vec3& offset, int n);

/// Bounds the Lebesgue constant of n Chebyshev points of the first kind: (2 / pi) log n + 1
/// (Trefethen 2013, theorem 15.2).
double ChebyshevLebesgue(int n);
} // namespace pixelexact
