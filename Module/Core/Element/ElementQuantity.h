// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/ChebyshevModel.h"
#include "Core/Bernstein/PieceForm.h"
#include "Core/Bernstein/RangeSearch.h"
#include "Core/Math/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// A scalar on one element, as a function of polynomials in eta, for bounds over boxes: a component
/// of a field, of a gradient, det J or an expression.
class ElementQuantity : public RangeFunction
{
public:
  /// False where a coefficient is NaN or infinite: nothing can be said then.
  [[nodiscard]] virtual bool IsFinite() const = 0;
  /// The cube of eta is cut into 2^Level() pieces along each direction, on which the polynomials
  /// are converted.
  [[nodiscard]] virtual int Level() const = 0;
  /// The scalar is in units of 2^Exponent().
  [[nodiscard]] virtual int Exponent() const = 0;
  /// The polynomials over the part `within`, in its own [-1, 1]^3, of a piece.
  [[nodiscard]] virtual std::vector<BoxPolynomial> Polynomials(
    const PieceForm::Piece& piece, const Box3& within) const = 0;
};

/// The components of a function on one element, as functions of polynomials in eta: what integrals
/// over surfaces need of a function without coefficients. Safe to use from several threads.
class ElementModels
{
public:
  virtual ~ElementModels() = default;

  /// False where a coefficient is NaN or infinite. The other functions must not be called then.
  [[nodiscard]] virtual bool IsFinite() const = 0;
  /// The lowest level on which the conversion of the polynomials is accurate.
  [[nodiscard]] virtual int Level() const = 0;
  /// These polynomials in eta over a piece of the cube.
  [[nodiscard]] virtual std::vector<BoxPolynomial> Polynomials(
    int level, const PieceForm::Piece& piece) const = 0;
  /// The components on a piece of a surface, from models of the polynomials, in their order. The
  /// error of a model is infinite where a component may be undefined or has no bound.
  [[nodiscard]] virtual std::vector<ChebyshevModel> Over(
    std::span<const ChebyshevModel> polynomials) const = 0;
  /// The range of each component over a box, from the polynomials over it.
  [[nodiscard]] virtual std::vector<Interval> Ranges(
    std::span<const BoxPolynomial> polynomials) const = 0;
};

/// Bounds of a scalar and of its gradient over a box: with d = xi - the box's middle, |d_k| <=
/// reach_k, the derivatives by xi are in slopes[j](d / reach).
struct JetBounds
{
  /// Hold all values, and those that FieldFunction::JetValue computes for values that the scalar's
  /// function takes; everything where one may be NaN.
  Interval values;
  /// Whether the scalar is continuous in the box, so that the mean value theorem holds with the
  /// slopes (kinks may be there).
  bool isContinuous = false;
  std::array<AffineForm, 3> slopes;
  /// Second derivatives by xi, 11, 12, 13, 22, 23, 33, in the same way; none where they are not
  /// available.
  std::optional<std::array<AffineForm, 6>> seconds;
  Vec3 reach{ 0.0 };
  /// Bounds the errors of values and slopes as Evaluate computes them, and of values that
  /// FieldFunction::JetValue computes. Infinite where they are not known.
  double valueError = 0.0;
  double slopeError = 0.0;
};

/// A scalar on one element with its gradient by xi: what proofs along lines and on planes need of a
/// function without coefficients. Safe to use from several threads.
class ElementJet
{
public:
  virtual ~ElementJet() = default;

  /// False where a coefficient is NaN or infinite. The other functions must not be called then.
  [[nodiscard]] virtual bool IsFinite() const = 0;
  /// The lowest level on which the conversion of the jet's polynomials is accurate.
  [[nodiscard]] virtual int Level() const = 0;
  /// These polynomials in eta over a piece of the cube.
  [[nodiscard]] virtual std::vector<BoxPolynomial> Polynomials(
    int level, const PieceForm::Piece& piece) const = 0;
  /// `forms` and `hulls` enclose them, in their order, the forms as functions of d / reach.
  [[nodiscard]] virtual JetBounds Over(
    std::span<const AffineForm> forms, std::span<const Interval> hulls) const = 0;
  /// An estimate of the work of bounds over a box: the polynomials' coefficients times their
  /// numbers along a direction, summed, and the operations of one call of Over.
  struct Work
  {
    std::int64_t terms = 0;
    std::int64_t operations = 0;
  };
  [[nodiscard]] virtual Work WorkOf(int level) const = 0;
  /// The operations of Evaluate at a point, about.
  [[nodiscard]] virtual std::int64_t PointOperations() const = 0;

  /// Values and derivatives by x in world units at points of the element.
  virtual void Evaluate(
    std::span<const Vec3> xi, std::span<double> values, std::span<Vec3> gradients) const = 0;
};
} // namespace pixelexact
