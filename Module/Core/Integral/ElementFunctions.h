// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ElementPolynomial.h"
#include "Core/Element/ElementQuantity.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"
#include "Core/Integral/BoxModel.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
class IntegralCut;

/// The field, the surface and the clips of an integral. The views must outlive the object.
struct IntegralQuestion
{
  Mesh mesh;
  const Field* field = nullptr;     ///< null: the area alone
  const IntegralCut* cut = nullptr; ///< null: faces of elements
  /// The surface counts only where none of these polynomials is positive.
  std::span<const ImplicitPolynomial> clips{};
  /// The surface counts only where the field, a scalar that is no density, is at most this value.
  std::optional<double> below{};
  /// A box that holds the part of the surface that counts; none where it is unbounded.
  std::optional<Box3> within{};

  [[nodiscard]] int Components() const { return field != nullptr ? field->values.components : 0; }
  /// Whether the field is an expression.
  [[nodiscard]] bool IsFunction() const { return field != nullptr && field->function != nullptr; }
  [[nodiscard]] bool HasFlux() const { return Components() == 3; }
  /// The number of integrals: the area, the components, and the flux.
  [[nodiscard]] std::size_t Quantities() const
  {
    return 1 + static_cast<std::size_t>(Components()) + (HasFlux() ? 1 : 0);
  }
};

/// A box in one of the pieces of an element's cube, in the piece's own [-1,1]^3.
struct PieceBox
{
  PieceForm::Piece piece{};
  Vec3 lower{ -1.0 };
  Vec3 upper{ 1.0 };
};

/// The polynomials in eta over boxes that integrals over a cut of one element need.
class ElementFunctions
{
public:
  ElementFunctions(const IntegralQuestion& question, int element);

  /// Whether all coefficients are finite.
  [[nodiscard]] bool IsFinite() const { return Finite; }
  /// Whether the field's coefficients are all zero.
  [[nodiscard]] bool IsZeroField() const;
  /// Whether the polynomial of the cut-surface or of a clip exceeds the supported degree.
  [[nodiscard]] bool IsTooHigh() const { return TooHigh; }
  [[nodiscard]] Shape GetShape() const { return Map.space.shape; }
  /// The cube has 2^Level() pieces along each direction.
  [[nodiscard]] int Level() const { return level_; }
  [[nodiscard]] std::vector<PieceBox> Pieces() const;
  /// Whether the end of a box is in a face of the cube.
  [[nodiscard]] bool IsOnCube(const PieceBox& box, int direction, bool upper) const;
  /// A direction's eta at the middle of a box, and half of the box's width in eta.
  [[nodiscard]] Interval Middle(const PieceBox& box, int direction) const;
  [[nodiscard]] Interval HalfWidth(const PieceBox& box, int direction) const;

  /// Unit() times the cut-surface's function.
  BoxPolynomial Cut(const PieceBox& box);
  [[nodiscard]] double Unit() const { return unit_; }
  /// A component of the map, in its modes' units: x = centre + Radius() y.
  BoxPolynomial Map3(const PieceBox& box, int component);
  [[nodiscard]] double Radius() const { return radius_; }
  /// The derivative of a component of the map by a xi.
  BoxPolynomial Slope(const PieceBox& box, int component, int xi);
  /// The components of the field's own values on a surface in a box, over 2^FieldExponent().
  /// `axes`: the box's directions of a, b and c in PointedModels. `places`: the part of the box
  /// that holds the surface; a function without coefficients and without models
  /// (FieldFunction::HasModels) is interpolated there, and its error is an estimate.
  std::vector<ChebyshevModel> Values(const PieceBox& box, const std::array<int, 3>& axes,
    const PointedModels& place, const PieceBox& places);
  /// Their ranges over a box.
  std::vector<Interval> ValueRanges(const PieceBox& box);
  [[nodiscard]] int FieldExponent() const;

  /// The value of z = x - origin where y is zero.
  [[nodiscard]] Interval Shift(const Vec3& origin, int component) const;

  /// A clip's polynomial times some positive factor.
  BoxPolynomial Clip(const PieceBox& box, std::size_t clip);
  /// The polynomial `surface` of the place x over a box.
  [[nodiscard]] ScaledPolynomial Over(const ImplicitPolynomial& surface, const PieceBox& box);

  /// A component of the field that defines the cut-surface, over 2^CutExponent(), and its
  /// derivative by a xi.
  BoxPolynomial CutValues(const PieceBox& box, int component);
  BoxPolynomial CutSlope(const PieceBox& box, int component, int xi);
  [[nodiscard]] int CutExponent() const;

  [[nodiscard]] const IntegralQuestion& Question() const { return question_; }
  [[nodiscard]] int Element() const { return element_; }

private:
  /// A component of the field over a box; of a function, interpolated.
  BoxPolynomial ValuesOver(const PieceBox& box, int component);
  [[nodiscard]] BoxPolynomial SampledValues(const PieceBox& box, int component) const;
  /// The polynomials of the function's models over a box.
  std::vector<BoxPolynomial> OfFunction(const PieceBox& box);
  /// Drops what is kept for another piece.
  void Enter(const PieceForm::Piece& piece);
  /// A function over a whole piece, computed on first use and kept for one piece at a time.
  const BoxPolynomial& Over(const PieceForm::Piece& piece, std::size_t function);

  IntegralQuestion question_;
  int element_;
  ScaledModes Map;
  std::unique_ptr<const ScaledModes> Modes;
  std::unique_ptr<const ElementModels> Function;
  std::unique_ptr<const ScaledModes> CutModes;
  std::size_t FirstOfCut;
  int level_ = 0;
  double radius_;
  double unit_ = 1.0;
  bool Finite = true;
  bool TooHigh = false;
  PieceForm::Piece At{ -1, -1, -1 };
  std::vector<BoxPolynomial> Made;
  std::vector<BoxPolynomial> MadeOfFunction; ///< over the same piece; empty: not yet
};
} // namespace pixelexact
