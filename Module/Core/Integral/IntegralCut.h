// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/BoxModel.h"
#include "Core/Integral/ElementFunctions.h"

#include <array>

namespace pixelexact
{
struct SurfaceModels;

/// The gradient of S over a parametrised surface in an element.
struct CutGradient
{
  std::array<ChebyshevModel, 3> gradient;
  /// It is det J times the gradient, with J as SurfaceModels has it: in world units radius^2 times.
  bool timesDeterminant = false;
  bool constant = false; ///< the same everywhere
};

/// A cut-surface: the zeros of a function S that in each element is a polynomial in eta.
class IntegralCut
{
public:
  virtual ~IntegralCut() = default;

  /// The field that S is made of; null where S is a function of the place.
  [[nodiscard]] virtual const Field* MadeOf() const { return nullptr; }
  /// How often S multiplies the map, or the field.
  [[nodiscard]] virtual int Factor() const = 0;
  /// Over a box, made of what the map and the field are there: where S is small so is its error.
  [[nodiscard]] virtual ScaledPolynomial Over(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  /// How far S may be off over a box, because of what is uncertain in the mesh or the field.
  [[nodiscard]] virtual double Uncertainty(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  [[nodiscard]] virtual CutGradient Gradient(ElementFunctions& functions, const PieceBox& box,
    const std::array<int, 3>& axes, const PointedModels& place,
    const SurfaceModels& models) const = 0;
  /// |grad S| |det J| over a box, in world units.
  [[nodiscard]] virtual Interval Stretch(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  /// At most so much area is in a box.
  [[nodiscard]] virtual double AreaIn(ElementFunctions& functions, const PieceBox& box) const = 0;

protected:
  IntegralCut() = default;
  IntegralCut(const IntegralCut&) = default;
  IntegralCut& operator=(const IntegralCut&) = default;
};

/// The zeros of a polynomial of the place.
class PolynomialSurface final : public IntegralCut
{
public:
  explicit PolynomialSurface(const ImplicitPolynomial& surface)
    : Polynomial(surface)
  {
  }
  [[nodiscard]] int Factor() const override { return Polynomial.Degree(); }
  [[nodiscard]] ScaledPolynomial Over(
    ElementFunctions& functions, const PieceBox& box) const override;
  [[nodiscard]] double Uncertainty(ElementFunctions& functions, const PieceBox& box) const override;
  [[nodiscard]] CutGradient Gradient(ElementFunctions& functions, const PieceBox& box,
    const std::array<int, 3>& axes, const PointedModels& place,
    const SurfaceModels& models) const override;
  [[nodiscard]] Interval Stretch(ElementFunctions& functions, const PieceBox& box) const override;
  /// A line meets the surface at most as often as its degree: at most so often the sum of the
  /// sides' areas of a box that contains the part. The map is taken to be injective there.
  [[nodiscard]] double AreaIn(ElementFunctions& functions, const PieceBox& box) const override;

private:
  ImplicitPolynomial Polynomial;
};

/// Where a component of a field has a value. S is the field's less the value, of a magnitude that
/// of the squares.
class IsoValueSurface final : public IntegralCut
{
public:
  static constexpr int kOfMagnitude = -1;
  /// `component`: or kOfMagnitude, which of a scalar is itself. Throws Unsupported for mapped
  /// fields; InvalidData for a component that is not there, for a value that is not finite, and for
  /// a magnitude that is not positive.
  IsoValueSurface(const Field& field, int component, double value);
  [[nodiscard]] const Field* MadeOf() const override { return field_; }
  [[nodiscard]] int Factor() const override { return First == Last ? 1 : 2; }
  [[nodiscard]] ScaledPolynomial Over(
    ElementFunctions& functions, const PieceBox& box) const override;
  /// What the rounding of the field's coefficients makes of zero.
  [[nodiscard]] double Uncertainty(ElementFunctions& functions, const PieceBox& box) const override;
  [[nodiscard]] CutGradient Gradient(ElementFunctions& functions, const PieceBox& box,
    const std::array<int, 3>& axes, const PointedModels& place,
    const SurfaceModels& models) const override;
  [[nodiscard]] Interval Stretch(ElementFunctions& functions, const PieceBox& box) const override;
  /// By Cauchy's formula in the box: a line along eta_d meets the surface at most as often as the
  /// order of the first derivative of S by eta_d that has one sign, and what a face across eta_d
  /// has as area becomes that times the length of the product of its tangents.
  [[nodiscard]] double AreaIn(ElementFunctions& functions, const PieceBox& box) const override;

private:
  const Field* field_;
  int First;
  int Last; ///< components
  double Value;
};
} // namespace pixelexact
