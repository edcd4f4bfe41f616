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
  /// Whether `gradient` is multiplied by det J, with J as in SurfaceModels. The product in world
  /// units is radius^2 times this one.
  bool timesDeterminant = false;
  bool constant = false; ///< the same everywhere
};

/// A cut-surface: the zeros of a function S that is a polynomial in eta in each element.
class IntegralCut
{
public:
  virtual ~IntegralCut() = default;

  /// The field that defines S; null where S is a function of the place.
  [[nodiscard]] virtual const Field* MadeOf() const { return nullptr; }
  /// The degree of S in the map, or in the field.
  [[nodiscard]] virtual int Factor() const = 0;
  /// The polynomial over a box, computed from the map and the field there, so that where S is small
  /// its error is small as well.
  [[nodiscard]] virtual ScaledPolynomial Over(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  /// Bounds the error of S over a box from the uncertainty of the mesh or the field.
  [[nodiscard]] virtual double Uncertainty(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  [[nodiscard]] virtual CutGradient Gradient(ElementFunctions& functions, const PieceBox& box,
    const std::array<int, 3>& axes, const PointedModels& place,
    const SurfaceModels& models) const = 0;
  /// |grad S| |det J| over a box, in world units.
  [[nodiscard]] virtual Interval Stretch(
    ElementFunctions& functions, const PieceBox& box) const = 0;
  /// Bounds the area of the surface in a box.
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
  /// A line meets the surface at most as often as its degree. The area is at most that number times
  /// the sum of the sides' areas of a box that contains the part, if the map is injective there.
  [[nodiscard]] double AreaIn(ElementFunctions& functions, const PieceBox& box) const override;

private:
  ImplicitPolynomial Polynomial;
};

/// The iso-surface of a component of a field. S is the field minus the value; for a magnitude, the
/// difference of their squares.
class IsoValueSurface final : public IntegralCut
{
public:
  static constexpr int kOfMagnitude = -1;
  /// `component`: or kOfMagnitude, which for a scalar is the component itself. Throws Unsupported
  /// for mapped fields; InvalidData for a component that does not exist, for a value that is not
  /// finite, and for a magnitude that is not positive.
  IsoValueSurface(const Field& field, int component, double value);
  [[nodiscard]] const Field* MadeOf() const override { return field_; }
  [[nodiscard]] int Factor() const override { return First == Last ? 1 : 2; }
  [[nodiscard]] ScaledPolynomial Over(
    ElementFunctions& functions, const PieceBox& box) const override;
  /// Bounds the error of S by the rounding of the field's coefficients.
  [[nodiscard]] double Uncertainty(ElementFunctions& functions, const PieceBox& box) const override;
  [[nodiscard]] CutGradient Gradient(ElementFunctions& functions, const PieceBox& box,
    const std::array<int, 3>& axes, const PointedModels& place,
    const SurfaceModels& models) const override;
  [[nodiscard]] Interval Stretch(ElementFunctions& functions, const PieceBox& box) const override;
  /// By Cauchy's formula in the box: a line along eta_d meets the surface at most as often as the
  /// order of the first derivative of S by eta_d that has one sign. A face across eta_d contributes
  /// this number times the length of the product of its tangents.
  [[nodiscard]] double AreaIn(ElementFunctions& functions, const PieceBox& box) const override;

private:
  const Field* field_;
  int First;
  int Last; ///< components
  double Value;
};
} // namespace pixelexact
