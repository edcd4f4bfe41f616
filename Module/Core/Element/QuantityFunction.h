// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/ElementQuantity.h"
#include "Core/Element/Ranges.h"

namespace pixelexact
{
/// A quantity (Ranges.h) as an expression in polynomials. Their order: the nine dPhi_i / dxi_j,
/// i slowest, where the quantity needs the map; then the field's values, or the derivatives of the
/// component by xi.
class QuantityFunction : public ElementQuantity
{
public:
  explicit QuantityFunction(const RangeQuestion& question);

  [[nodiscard]] Interval Enclose(std::span<const BoxPolynomial> polynomials) const override;
  [[nodiscard]] Interval AtCorner(
    std::span<const BoxPolynomial> polynomials, unsigned corner) const override;
  [[nodiscard]] PointValue AtLikelyMinimum(
    std::span<const BoxPolynomial> polynomials) const override;
  [[nodiscard]] int TellingDifference() const override;

  /// Where J is constant up to rounding (straight simplices), replaces the nine derivatives and the
  /// polynomials after them by the polynomials in eta of the quantity, or of the vector whose norm
  /// it is: they cost a fraction, and their hulls are sharp.
  void ToWorld(std::vector<BoxPolynomial>& polynomials) const;

  /// The quantity is of dimension length^this, times the field's.
  [[nodiscard]] int PowerOfLength() const;

private:
  /// The quantity, or the vector whose norm it is.
  template <class T>
  [[nodiscard]] std::vector<T> Combine(std::span<const T> p) const;
  [[nodiscard]] Interval Value(const std::vector<Interval>& polynomials) const;
  /// Whether the field is zero. Every quantity except det J is a linear map of the field, or the
  /// norm of one.
  [[nodiscard]] bool IsOfZeroField(std::span<const BoxPolynomial> polynomials) const;
  [[nodiscard]] bool IsPlain() const;
  [[nodiscard]] bool NeedsMap() const;
  [[nodiscard]] bool IsMagnitude() const;

  Quantity quantity_;
  Mapping mapping_;
  std::size_t Index; ///< of the component that is sought among those that Combine could give
};
} // namespace pixelexact
