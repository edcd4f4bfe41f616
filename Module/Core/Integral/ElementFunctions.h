// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CutFunction.h"
#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"

#include <memory>
#include <vector>

namespace pixelexact
{
/// What is integrated. The views must outlive whoever holds it.
struct IntegralQuestion
{
  Mesh mesh;
  const Field* field = nullptr;     ///< null: the area alone
  const QuadricForm* cut = nullptr; ///< null: faces of elements

  [[nodiscard]] int Components() const { return field != nullptr ? field->values.components : 0; }
  [[nodiscard]] bool HasFlux() const { return Components() == 3; }
  /// The area, the components' integrals, the flux.
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

/// The polynomials in eta that integrals over a cut of one element are made of, over boxes.
class ElementFunctions
{
public:
  ElementFunctions(const IntegralQuestion& question, int element);

  /// Whether all coefficients are finite.
  [[nodiscard]] bool IsFinite() const { return Finite; }
  /// The polynomial of a quadric has a degree that is not taken.
  [[nodiscard]] bool IsTooHigh() const { return TooHigh; }
  [[nodiscard]] Shape GetShape() const { return Map.space.shape; }
  /// The cube is cut into 2^Level() pieces along each direction.
  [[nodiscard]] int Level() const { return TheLevel; }
  [[nodiscard]] std::vector<PieceBox> Pieces() const;
  /// Whether the end of a box is in a face of the cube.
  [[nodiscard]] bool IsOnCube(const PieceBox& box, int direction, bool upper) const;
  /// A direction's eta at the middle of a box, and half of the box's width in eta.
  [[nodiscard]] Interval Middle(const PieceBox& box, int direction) const;
  [[nodiscard]] Interval HalfWidth(const PieceBox& box, int direction) const;

  /// unit times the cut-surface's function.
  BoxPolynomial Cut(const PieceBox& box);
  [[nodiscard]] double Unit() const { return TheUnit; }
  /// The map, in its modes' units: x = centre + Radius() y.
  BoxPolynomial Map3(const PieceBox& box, int component);
  [[nodiscard]] double Radius() const { return TheRadius; }
  /// Its derivative by a xi.
  BoxPolynomial Slope(const PieceBox& box, int component, int xi);
  /// A component of the field's own values, over 2^FieldExponent().
  BoxPolynomial Values(const PieceBox& box, int component);
  [[nodiscard]] int FieldExponent() const;

  /// z = x - the quadric's origin, of y.
  [[nodiscard]] Interval Shift(int component) const
  {
    return Z0[static_cast<std::size_t>(component)];
  }

  [[nodiscard]] const IntegralQuestion& Question() const { return TheQuestion; }
  [[nodiscard]] int Element() const { return TheElement; }

private:
  /// Over a whole piece; made when first asked for, for one piece at a time.
  const BoxPolynomial& Over(const PieceForm::Piece& piece, std::size_t function);

  IntegralQuestion TheQuestion;
  int TheElement;
  ScaledModes Map;
  std::unique_ptr<const ScaledModes> Modes;
  int TheLevel = 0;
  double TheRadius;
  double TheUnit = 1.0;
  bool Finite = true;
  bool TooHigh = false;
  std::array<Interval, 3> Z0;
  PieceForm::Piece At{ -1, -1, -1 };
  std::vector<BoxPolynomial> Made;
};
} // namespace pixelexact
