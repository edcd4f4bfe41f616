// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Rational/RationalElement.h"

#include "Core/Basis/ChangeOfBasis.h"

#include <memory>
#include <span>

// Rational Bezier prisms, triangles (prisms of degree 0 across) and tetrahedra as polynomials of
// their own spaces, with the bound of RationalElement.h: in eta all are products of intervals.
namespace pixelexact::rational
{
/// Numbers at a prism's or tetrahedron's control points, ordered as ChangeOfBasis::Prism and
/// ::Tetrahedron number functions, as those of the same function of eta on the cube, of degrees
/// space.order, with the last direction fastest. Means with weights that are not negative: positive
/// numbers stay so.
std::vector<long double> Collapse(const Space& space, std::span<const long double> control);

/// The polynomials of a prism's or tetrahedron's space by their values at nodes. Nodes on a face
/// depend only on that face; on edges, and along a prism's quadrilaterals, they are
/// Gauss-Lobatto-Legendre points (T. Isaac, Recursive, parameter-free, explicitly defined
/// interpolation nodes for simplices, SIAM J. Sci. Comput. 42, 2020).
class SimplexBasis
{
public:
  explicit SimplexBasis(const Space& space);

  [[nodiscard]] const Space& GetSpace() const { return Change.Target(); }
  /// The change of basis from values at the nodes.
  [[nodiscard]] const ChangeOfBasis& GetChange() const { return Change; }

  /// The values of N / w at the nodes, component by component; `element` is a function of eta.
  void NodeValues(const RationalElement& element, std::span<double> values) const;

  /// A bound of |N / w - P| as LossOf's, of the polynomial P with the coefficients that the change
  /// of basis gives for the values at the nodes.
  [[nodiscard]] double LossOf(const RationalElement& element, LineTables& tables) const;

private:
  std::vector<std::array<long double, 3>> Nodes; ///< in eta
  ChangeOfBasis Change;
};
} // namespace pixelexact::rational
