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
/// The xi of the middle of a box.
[[nodiscard]] Vec3 CentreOf(Shape shape, const EtaBox& box);
/// The largest distance, along each axis, of a xi of the box from CentreOf.
[[nodiscard]] Vec3 ReachOf(Shape shape, const EtaBox& box);

/// The polynomials of an element's map and of functions on it over a piece of the cube, from which
/// all bounds of boxes follow. They are kept, because conversion costs more than evaluation. In the
/// units of the modes' exponents.
class EdgePolynomials
{
public:
  /// A function, given by its modes.
  struct Function
  {
    const ScaledModes* modes;
    int component;
  };
  /// `functions`: of one space; empty: the map alone. All must be finite.
  EdgePolynomials(const ScaledModes& map, std::span<const Function> functions, int level,
    const PieceForm::Piece& piece);

  /// The same polynomials of lower degrees (PolynomialBatch::Lowered). None where the saving is
  /// small, or divisors remain.
  [[nodiscard]] std::unique_ptr<const EdgePolynomials> Lowered() const;
  /// The estimated cost of subdividing boxes that lie in this piece alone, in nanoseconds of one
  /// core: for the map, and, where it is regular, for the other functions.
  struct Cost
  {
    std::int64_t ofMap = 0;
    std::int64_t ofRest = 0;
  };
  [[nodiscard]] Cost SubdivisionCost() const;
  [[nodiscard]] static std::int64_t CostOf(const Degrees& degree);

  /// An estimate of the bytes held.
  [[nodiscard]] std::size_t Bytes() const;

  /// Hulls of the map over a part of the piece, given in its own [-1, 1]^3.
  struct MapHulls
  {
    std::array<Interval, 3> image;
    std::array<std::array<Interval, 3>, 3> slopes; ///< by coordinate and xi
  };
  [[nodiscard]] MapHulls MapOver(const Box3& within) const;

  /// Second derivatives by xi, 11, 12, 13, 22, 23, 33, as affine bounds in xi minus that of the
  /// part's middle (CentreOf).
  using SecondBounds = std::array<AffineBound, 6>;
  struct Curves
  {
    std::array<SecondBounds, 3> map;
    std::vector<SecondBounds> functions;
  };
  /// Hulls of the derivatives by xi of the map's coordinates and of the functions, and of the
  /// functions' values. `map`: of the same part.
  struct Hulls
  {
    std::array<HessianFunction::XiRanges, 3> map;
    std::vector<HessianFunction::XiRanges> functions;
    std::vector<Interval> values;
    std::optional<Curves> curves;
  };
  /// `box`: the same part in eta, for `curves`; null: without them.
  [[nodiscard]] Hulls Over(const Box3& within, const MapHulls& map, const EtaBox* box) const;

  /// The coefficients of xi - `origin` over a box, in Bernstein form of this degree, at least 1 in
  /// each direction.
  [[nodiscard]] static std::vector<Vec3> PlacesIn(
    Shape shape, const EtaBox& box, const Vec3& origin, const Degrees& degree);

private:
  /// Converts second derivatives by eta to those by xi.
  void MakeByXi(const Box3& within, Hulls& hulls) const;
  EdgePolynomials(Shape shape, PolynomialBatch map, PolynomialBatch bends, PolynomialBatch field);
  /// `ofMap`: HessianFunction's polynomials of the map.
  EdgePolynomials(const ScaledModes& map, std::span<const Function> functions, int level,
    const PieceForm::Piece& piece, const std::vector<BoxPolynomial>& ofMap);

  Shape shape_;
  PolynomialBatch Map;   ///< images, then derivatives by xi
  bool IsByXi;           ///< the second derivatives below are by xi, and no divisor remains
  PolynomialBatch Bends; ///< of the map: derivatives of those by eta, or second ones by xi
  PolynomialBatch Field; ///< of each function: its value, and both
  std::vector<BoxPolynomial> Factors; ///< that are divided by, or multiplied with
};
} // namespace pixelexact
