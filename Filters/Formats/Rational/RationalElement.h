// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Rational/LineMatrix.h"

#include <limits>
#include <optional>
#include <span>

// Rational Bezier hexahedra as polynomials, with a proven bound of what is lost
// (bases-and-kernels.md).
namespace pixelexact::rational
{
inline constexpr long double kLongRoundoff = std::numeric_limits<long double>::epsilon() / 2;

using Orders = std::array<int, 3>;

/// `components` functions N / w on [-1,1]^3, N and w in Bernstein's basis with the last direction
/// fastest. A plane element has degree 0 across.
struct RationalElement
{
  Orders degree{};
  std::vector<long double> weights; ///< positive
  /// Component by component: weight times (value - shift). Values near the shift are not drowned
  /// in the rounding of what is far from it.
  std::vector<long double> numerators;
  std::vector<long double> shift; ///< per component
  bool isPolynomial = false;      ///< the weights are all the same number

  [[nodiscard]] int Components() const { return static_cast<int>(shift.size()); }
};

/// The largest difference of one component's control points.
double ExtentOf(const RationalElement& element);

/// Whether the weights vary along a direction, by more than rounding.
bool VariesAlong(const RationalElement& element, std::size_t direction);

/// The values at the tensor nodes of an order (Gauss-Lobatto-Legendre; order 0: the centre),
/// component by component. They depend on a face's points alone where the nodes are on that face.
void NodeValues(const RationalElement& element, const Orders& order, LineTables& tables,
  std::span<double> values);

/// A bound of |N / w - P| on the element, of all components, where P is the polynomial of that
/// order through the nodes' values before they are rounded to double. Zero for polynomials whose
/// degree is not above the order. Proven, rounding included: w (N / w - P) is a polynomial, which
/// is known at zeros of Chebyshev's polynomials, and by the inequality of Ehlich and Zeller
/// (Math. Z. 86, 1964) everywhere.
double LossOf(const RationalElement& element, const Orders& order, LineTables& tables);

/// An estimate of the least orders, not below the degrees and at most `most`, with a loss of at
/// most `target`. None where these do not suffice; `worst` is then the direction that needs the
/// highest order.
struct OrderEstimate
{
  std::optional<Orders> order;
  int worst = 0;
};
OrderEstimate EstimateOrders(
  const RationalElement& element, double target, int most, LineTables& tables);
} // namespace pixelexact::rational
