// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

// The inverse of an element's map over a box of xi, as an analytic function on a complex
// neighbourhood. Along a ray, xi and every polynomial of xi are then analytic functions of t, and
// their interpolants in Chebyshev's points have a proven error. The map is replaced by the
// polynomial that has exactly the computed coefficients, which is off by rounding at real points
// alone: the rounding of coefficients would grow with the polydisc.
//
// With s = (xi - centre) / halfWidth and z = A^-1 (Phi(xi) - a_0), A and a_0 the coefficients of
// degree 0 and 1 of Phi's Chebyshev series over the box, z = s + N(s). On the polydisc |s_d| <= R
// of complex s, |T_n(s)| <= |T_n(i R)|, so sums over the coefficients bound |N| and its Lipschitz
// constant L in the max norm. If L < 1, s -> z - N(s) is a contraction of the polydisc for each
// complex z with |z_d| <= R - max |N|: exactly one s belongs to each such z, and it is analytic in
// z. The bound of the interpolant is theorem 8.2 of L. N. Trefethen, Approximation Theory and
// Approximation Practice (2013); it holds for points of the first kind as well, because both kinds
// alias each coefficient beyond the degree to one within it.
namespace pixelexact
{
/// Radii of polydiscs about the middle of a box, in half widths of the box.
inline constexpr std::array<double, 8> kDiscRadii{ 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0 };

/// One number for each of kDiscRadii.
using DiscBounds = std::array<double, kDiscRadii.size()>;

/// Bounds the Lebesgue constant of n Chebyshev points of the first kind: (2 / pi) log n + 1
/// (Trefethen 2013, theorem 15.2).
[[nodiscard]] double ChebyshevLebesgue(int n);

/// The largest number of Chebyshev's points along a ray.
inline constexpr int kMaxRayPoints = 24;

/// The Chebyshev series of polynomials over a box of xi, component by component; index
/// (i (Q + 1) + j) (R + 1) + k. Along each xi the degree is that of the space's order.
struct BoxSeries
{
  std::array<int, 3> degree{};
  std::vector<std::vector<double>> coefficients;
  /// The series with exactly these coefficients is off the function by at most this, anywhere in
  /// the box; by component. Infinite for a pyramid, whose functions are no polynomials of xi.
  std::vector<double> error;
  /// How far a kernel's value may be off the function in the box; by component.
  std::vector<double> noise;

  /// Bounds of |f - f_0| over the polydiscs, f_0 the series' constant term.
  [[nodiscard]] DiscBounds OverDiscs(std::size_t component) const;
};

/// The largest factor by which a polynomial of these degrees that is bounded over the box |s_d| <=
/// 1, as are the series' errors, may exceed its bound at real s with |s_d| <= reach_d.
[[nodiscard]] double GrowthOutside(const std::array<int, 3>& degree, const Vec3& reach);

/// The series of `components` functions of an element over a box, from their values in Chebyshev's
/// points. `coefficients`: as Expansion has them.
[[nodiscard]] BoxSeries MakeBoxSeries(
  const Space& space, const double* coefficients, int components, const Box3& box);

/// See above. Lengths are in the element's units, y = (x - Mesh::centre) / Mesh::size.
struct XiInverse
{
  Box3 box; ///< of xi
  Vec3 centre{ 0.0 };
  Vec3 halfWidth{ 1.0 };
  std::array<double, 3> origin{};  ///< a_0
  std::array<double, 9> inverse{}; ///< about A^-1, row-major; z is defined with these numbers
  /// [k]: each complex z with max norm <= reach[k] has exactly one s with max norm <=
  /// kDiscRadii[k], which is analytic in z; <= 0: not proven, as for radii below 1.
  DiscBounds reach{};
  /// |z_d - s_d| of all real s of the box is at most this.
  Vec3 deviation{ 0.0 };
  /// Bounds how far z may be off by the rounding of the series and of kernel values in the box, by
  /// the mesh's uncertainty and by the product with A^-1; without that of y.
  double slack = 0.0;
  std::array<int, 3> degree{}; ///< of Phi in each xi

  [[nodiscard]] bool IsProven() const;
  /// A^-1 v.
  [[nodiscard]] Vec3 Apply(const Vec3& v) const;
  /// The largest change of z by a change of y of one unit in every coordinate.
  [[nodiscard]] double Norm() const;
  /// The largest factor of the max norm of a change of s by a change of z, at real z with max norm
  /// <= r; and the number of the polydisc that proves it, -1 and infinity if none does.
  struct Slope
  {
    double factor;
    int disc;
  };
  [[nodiscard]] Slope SlopeAt(double r, double change) const;
};

/// `phi`: the series of the element's map over the box.
[[nodiscard]] XiInverse MakeXiInverse(
  const Mesh& mesh, int element, const BoxSeries& phi, const Box3& box);

/// The ellipses of complex x, for each polydisc of s, in which f(s(z)) is analytic on the line
/// z = middle + x half, x in [-1,1].
class RayEllipses
{
public:
  RayEllipses(const XiInverse& inverse, const Vec3& middle, const Vec3& half);

  /// The largest |f - p| on the line, for the interpolant p in n Chebyshev points of the first
  /// kind. `bounds`: of |f - f_0| over the polydiscs; kDiscRadii for the s themselves. Infinite
  /// where nothing is proven.
  [[nodiscard]] double Error(const DiscBounds& bounds, int n) const;
  /// The number of points with which Error is about the tolerance; at most kMaxRayPoints.
  [[nodiscard]] int PointsFor(const DiscBounds& bounds, double tolerance) const;

private:
  DiscBounds rho_{}; ///< sums of the half axes; 0: there is no ellipse
};
} // namespace pixelexact
