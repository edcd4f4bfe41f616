// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/PolynomialBatch.h"
#include "Core/Element/HessianFunction.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// The polynomials of an element's map and of components of a field over a piece of the cube, from
/// which all that is known of its boxes is made: kept, because converting them costs more than
/// asking. In the units of the modes' exponents.
class EdgePolynomials
{
public:
  /// `components` of them, from the first one on; 0: of the map alone. Both must be finite.
  EdgePolynomials(const ScaledModes& map, const ScaledModes& field, int components, int level,
    const PieceForm::Piece& piece);

  /// About the bytes held.
  [[nodiscard]] std::size_t Bytes() const;

  /// Of the map over a part of the piece, given in its own [-1, 1]^3.
  struct MapHulls
  {
    std::array<Interval, 3> image;
    std::array<std::array<Interval, 3>, 3> slopes; ///< by coordinate and xi
  };
  [[nodiscard]] MapHulls MapOver(const Box3& within) const;

  /// Of the map's coordinates, then of the components: derivatives by xi; and the components'
  /// values. `map`: of the same part.
  struct Hulls
  {
    std::array<HessianFunction::XiRanges, 3> map;
    std::vector<HessianFunction::XiRanges> components;
    std::vector<Interval> values;
  };
  [[nodiscard]] Hulls Over(const Box3& within, const MapHulls& map) const;

private:
  /// `ofMap`: HessianFunction's polynomials of the map.
  EdgePolynomials(const ScaledModes& map, const ScaledModes& field, int components, int level,
    const PieceForm::Piece& piece, const std::vector<BoxPolynomial>& ofMap);

  Shape TheShape;
  PolynomialBatch Map;   ///< images, then derivatives by xi
  PolynomialBatch Bends; ///< of the map: derivatives of those by eta
  PolynomialBatch Field; ///< of each component: its value, and both
  std::vector<BoxPolynomial> Factors; ///< that are divided by, or multiplied with
};
} // namespace pixelexact
