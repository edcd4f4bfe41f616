// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/PolynomialBatch.h"
#include "Core/Element/HessianFunction.h"
#include "Core/Tree/EtaBox.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// In xi, of the middle of a box.
[[nodiscard]] Vec3 CentreOf(Shape shape, const EtaBox& box);
/// No xi of the box is farther from there along an axis.
[[nodiscard]] Vec3 ReachOf(Shape shape, const EtaBox& box);

/// The polynomials of an element's map and of functions on it over a piece of the cube, from
/// which all that is known of its boxes is made: kept, because converting them costs more than
/// asking. In the units of the modes' exponents.
class EdgePolynomials
{
public:
  /// A function, by its modes.
  struct Function
  {
    const ScaledModes* modes;
    int component;
  };
  /// `functions`: of one space; none: of the map alone. All must be finite.
  EdgePolynomials(const ScaledModes& map, std::span<const Function> functions, int level,
    const PieceForm::Piece& piece);

  /// The same, of lower degrees (PolynomialBatch::Lowered); nothing where that is not much less, or
  /// factors are left to divide by.
  [[nodiscard]] std::unique_ptr<const EdgePolynomials> Lowered() const;
  /// About what halving boxes in it costs, in nanoseconds of one core, where they are in no other
  /// piece: because of the map, and, where it is regular, because of the rest.
  struct Cost
  {
    std::int64_t ofMap = 0;
    std::int64_t ofRest = 0;
  };
  [[nodiscard]] Cost SubdivisionCost() const;
  [[nodiscard]] static std::int64_t CostOf(const Degrees& degree);

  /// About the bytes held.
  [[nodiscard]] std::size_t Bytes() const;

  /// Of the map over a part of the piece, given in its own [-1, 1]^3.
  struct MapHulls
  {
    std::array<Interval, 3> image;
    std::array<std::array<Interval, 3>, 3> slopes; ///< by coordinate and xi
  };
  [[nodiscard]] MapHulls MapOver(const Box3& within) const;

  /// Second derivatives by xi, 11, 12, 13, 22, 23, 33, in terms of xi less that of the part's
  /// middle (CentreOf).
  using SecondBounds = std::array<AffineBound, 6>;
  struct Curves
  {
    std::array<SecondBounds, 3> map;
    std::vector<SecondBounds> functions;
  };
  /// Of the map's coordinates, then of the functions: derivatives by xi; and the functions' values.
  /// `map`: of the same part.
  struct Hulls
  {
    std::array<HessianFunction::XiRanges, 3> map;
    std::vector<HessianFunction::XiRanges> functions;
    std::vector<Interval> values;
    std::optional<Curves> curves;
  };
  /// `box`: the same part in eta, for `curves`; null: without them.
  [[nodiscard]] Hulls Over(const Box3& within, const MapHulls& map, const EtaBox* box) const;

  /// The coefficients of xi - `origin` over a box, in Bernstein form of this degree, 1 at least in
  /// each direction.
  [[nodiscard]] static std::vector<Vec3> PlacesIn(
    Shape shape, const EtaBox& box, const Vec3& origin, const Degrees& degree);

private:
  /// Second derivatives by eta become those by xi.
  void MakeByXi(const Box3& within, Hulls& hulls) const;
  EdgePolynomials(Shape shape, PolynomialBatch map, PolynomialBatch bends, PolynomialBatch field);
  /// `ofMap`: HessianFunction's polynomials of the map.
  EdgePolynomials(const ScaledModes& map, std::span<const Function> functions, int level,
    const PieceForm::Piece& piece, const std::vector<BoxPolynomial>& ofMap);

  Shape shape_;
  PolynomialBatch Map; ///< images, then derivatives by xi
  bool IsByXi; ///< the second derivatives below are by xi: no polynomials have to be divided by
  PolynomialBatch Bends; ///< of the map: derivatives of those by eta, or second ones by xi
  PolynomialBatch Field; ///< of each function: its value, and both
  std::vector<BoxPolynomial> Factors; ///< that are divided by, or multiplied with
};
} // namespace pixelexact
