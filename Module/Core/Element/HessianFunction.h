// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/RangeIngredients.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pixelexact
{
/// The polynomials that the second derivatives by xi of a map and a field consist of, and their
/// ranges. They follow from the first derivatives G, polynomials in eta (PieceForm.h), by the chain
/// rule, with e = (1 + eta) / 2 and h = (1 - eta) / 2:
///
///   hexahedron   G_1,  G_2,  G_3
///   prism        G_1 / h3,  G_2,  e1 G_1 / h3 + G_3
///   tetrahedron  G_1 / (h2 h3),  e1 G_1 / (h2 h3) + G_2 / h3,
///                e1 G_1 / (h2 h3) + e2 G_2 / h3 + G_3
///   pyramid      G_1 / h3,  G_2 / h3,  e1 G_1 / h3 + e2 G_2 / h3 + G_3
///
/// G_d by eta_d. In prisms and tetrahedra G is a polynomial in xi, so that what is divided by h
/// vanishes with it: on pieces that end where h = 0, the division is one of coefficients.
class HessianFunction
{
public:
  static constexpr std::size_t kPolynomials = 40;

  /// The polynomials over a piece, of three components of a map and of one of a field: the
  /// derivatives by xi, three a function; six derivatives of those by eta a function (divided by h
  /// where that is one of coefficients); e1, e2, and the remaining divisors of h2, h3.
  [[nodiscard]] static std::vector<BoxPolynomial> Polynomials(const ScaledModes& map,
    const ScaledModes& field, int component, int level, const PieceForm::Piece& piece);

  /// Of a function, the ranges over the part of its derivatives by xi, the first ones and 11, 12,
  /// 13, 22, 23, 33: hulls, and what interval arithmetic makes of them.
  struct XiRanges
  {
    std::array<Interval, 3> first;
    std::array<Interval, 6> second;
  };
  /// Of the map's components and of the field's, by the hulls of the polynomials.
  [[nodiscard]] static std::array<XiRanges, 4> RangesByXi(
    Shape shape, std::span<const Interval> hulls);

  /// Whether a derivative by eta_derivative is divided by h of a direction.
  [[nodiscard]] static bool IsDivided(Shape shape, int derivative, int direction);
};
} // namespace pixelexact
