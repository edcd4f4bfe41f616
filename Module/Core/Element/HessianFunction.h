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
  /// Places of second derivatives in the order 11, 12, 13, 22, 23, 33.
  static constexpr std::array<std::array<std::size_t, 3>, 3> kPlaces{ { { 0, 1, 2 }, { 1, 3, 4 },
    { 2, 4, 5 } } };

  /// The polynomials over a piece, for three components of a map and one of a field: the
  /// derivatives by xi, three per function; six derivatives of those by eta per function (divided
  /// by h where the division acts on coefficients); e1, e2, and the remaining divisors of h2, h3.
  [[nodiscard]] static std::vector<BoxPolynomial> Polynomials(const ScaledModes& map,
    const ScaledModes& field, int component, int level, const PieceForm::Piece& piece);

  /// The ranges over the piece of a function's first derivatives by xi and of its second ones, 11,
  /// 12, 13, 22, 23, 33: hulls, combined by interval arithmetic.
  struct XiRanges
  {
    std::array<Interval, 3> first;
    std::array<Interval, 6> second;
  };
  /// The ranges of the map's three components and of the field's component, from the hulls of the
  /// polynomials.
  [[nodiscard]] static std::array<XiRanges, 4> RangesByXi(
    Shape shape, std::span<const Interval> hulls);

  /// The second derivatives by xi, 11, 12, 13, 22, 23, 33, of a function, by the chain rule from
  /// the six derivatives of its slopes by eta, e1, e2, 1 / h3 and 1 / (h2 h3) (1 / h3 but of
  /// tetrahedra).
  template <class T>
  [[nodiscard]] static std::array<T, 6> SecondsByXi(Shape shape, std::span<const T, 6> byEta,
    const T& e1, const T& e2, const T& overH3, const T& overH23);

  /// The third derivatives by xi, 111, 112, 113, 122, 123, 133, 222, 223, 233, 333, of a component
  /// over a piece, as polynomials. Their errors are infinite on pyramids and on pieces that do not
  /// end where h = 0, where division by h does not act on coefficients.
  [[nodiscard]] static std::vector<BoxPolynomial> Thirds(
    const ScaledModes& modes, int component, int level, const PieceForm::Piece& piece);

  /// Whether a derivative by eta_derivative is divided by the h of a direction.
  [[nodiscard]] static bool IsDivided(Shape shape, int derivative, int direction);
};

template <class T>
std::array<T, 6> HessianFunction::SecondsByXi(Shape shape, std::span<const T, 6> byEta, const T& e1,
  const T& e2, const T& overH3, const T& overH23)
{
  const auto over = [](const T& v, const T& r, bool divided) { return divided ? v * r : v; };
  const bool curved1 = shape != Shape::Hexahedron;
  const bool curved2 = IsDivided(shape, 1, 2);
  const T by2 = over(byEta[4], overH3, curved2);
  std::array<T, 6> result{ over(byEta[0], overH23, curved1), over(byEta[1], overH23, curved1),
    over(byEta[3], overH23, curved1), over(byEta[2], overH3, curved2), by2, byEta[5] };
  if (shape == Shape::Tetrahedron)
  {
    result[3] = result[3] + e1 * result[1];
    result[4] = result[4] + e1 * result[2];
  }
  if (curved1)
  {
    result[5] = result[5] + e1 * result[2];
  }
  if (curved2)
  {
    result[5] = result[5] + e2 * by2;
  }
  return result;
}
} // namespace pixelexact
