// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourQuestion.h"
#include "Core/Element/RangeIngredients.h"

#include <memory>

namespace pixelexact
{
/// The two polynomials in eta whose common zeros are an element's contour: of the field's value,
/// f, and of the cut-surface, s, each scaled by a power of two.
struct CurvePolynomials
{
  BoxPolynomial f;
  BoxPolynomial s;

  /// Whether the hulls allow a common zero.
  [[nodiscard]] bool MayVanish() const;
  /// Subdivides both along a direction; becomes the lower child and returns the upper one.
  CurvePolynomials Subdivide(int direction);
};

/// Computes these polynomials over parts of one element from the stored map and field, exactly up
/// to the errors that the polynomials carry. A cut-surface that has no polynomial
/// (CutFunction::Polynomial) is interpolated; results for it are not proven.
class CurveEquations
{
public:
  /// Throws Unsupported for a mapped field (H(curl), H(div), density).
  CurveEquations(const ContourQuestion& question, int element);

  /// Whether all coefficients are finite, and the degrees are such as the root finder takes.
  [[nodiscard]] bool IsFinite() const { return Finite; }
  [[nodiscard]] bool IsTooHigh() const { return TooHigh; }
  [[nodiscard]] bool IsExact() const { return Question.cut->Polynomial() != nullptr; }

  /// Whether the hulls over the whole element, or over the part that no clip of the question
  /// removes, allow the surface or a value. A surface without a polynomial is always allowed.
  [[nodiscard]] bool MayMeetCut() const { return MeetsCut; }
  [[nodiscard]] bool MayHave(double value) const;

  /// log2 of the number of pieces along each direction on which the conversion is accurate.
  [[nodiscard]] int Level() const { return level_; }
  /// s over a box of the cube that lies in one piece of this level.
  [[nodiscard]] BoxPolynomial CutOver(int level, const Box3& box) const;
  /// The field's value minus `value`; for a norm, the difference of their squares.
  [[nodiscard]] BoxPolynomial FieldOver(int level, const Box3& box, double value) const;

private:
  /// The value, for a norm its square, scaled as the modes are.
  [[nodiscard]] Interval InModesUnits(double value) const;
  [[nodiscard]] BoxPolynomial SampledOver(const Box3& box) const;

  ContourQuestion Question;
  int Element;
  Shape shape_;
  ScaledModes Map;
  ScaledModes Modes; ///< of the field
  int level_ = 0;
  bool Finite = true;
  bool TooHigh = false;
  bool MeetsCut = false;
  Interval Reached; ///< holds the values (of a norm, their squares), scaled
};
} // namespace pixelexact
