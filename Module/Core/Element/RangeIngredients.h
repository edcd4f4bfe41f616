// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/BoxPolynomial.h"
#include "Core/Bernstein/PieceForm.h"
#include "Core/Math/Vec.h"

#include <vector>

namespace pixelexact
{
/// Modes of some components, scaled by a common power of two so that the largest magnitude is in
/// [1/2, 1): no product with the tables over- or underflows.
struct ScaledModes
{
  ScaledModes(const Space& itsSpace, const double* modes, int components);

  Space space;
  std::size_t width; ///< modes of a component
  std::vector<double> values;
  int exponent = 0;   ///< value = scaled value times 2^exponent
  bool finite = true; ///< all of them
};

/// A polynomial in eta from which a quantity of an element is computed.
struct RangeIngredient
{
  const ScaledModes* modes;
  int component;
  Part part;

  [[nodiscard]] const double* Modes() const
  {
    return modes->values.data() + modes->width * static_cast<std::size_t>(component);
  }
  /// The polynomial over the part `within`, in the piece's own [-1,1]^3, of a piece of the cube.
  /// Derivatives that are not bounded at a pyramid's apex (PieceForm::IsClosed) have an infinite
  /// error.
  [[nodiscard]] BoxPolynomial Over(
    int level, const PieceForm::Piece& piece, const Box3& within) const;
  /// Bounds the rounding of the kernels' values on a piece by 4 times the bound of its conversion:
  /// both compute the same sums with another order of the factors.
  [[nodiscard]] double RoundingInKernels(int level, const PieceForm::Piece& piece) const;
};

/// The piece that holds a box's middle.
PieceForm::Piece PieceAt(const Box3& box, int level);
/// The part of a box of eta in a piece, in the piece's own [-1,1]^3; lower > upper somewhere where
/// they do not meet.
Box3 PartInPiece(const Box3& box, int level, const PieceForm::Piece& piece);
/// The inverse: a part of a piece, in the piece's own [-1,1]^3, as a box of eta.
Box3 BoxOfPart(const Box3& within, int level, const PieceForm::Piece& piece);
/// Restricts a polynomial over [-1,1]^3 to this part of it.
void RestrictTo(const Box3& within, BoxPolynomial& polynomial);

/// Appends the three derivatives by xi of `count` components.
void AddDerivatives(
  const ScaledModes& modes, int first, int count, std::vector<RangeIngredient>& ingredients);

/// The level of pieces on which all of them are converted: 0 where the bound of the rounding errors
/// allows it, as for decaying coefficients of any order.
int LevelFor(const std::vector<RangeIngredient>& ingredients);
} // namespace pixelexact
