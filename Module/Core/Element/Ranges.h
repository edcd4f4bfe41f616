// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/ElementQuantity.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"

#include <functional>
#include <memory>

namespace pixelexact
{
/// A quantity of an element whose range is computed.
enum class Quantity : std::uint8_t
{
  /// A component of the field's world value (see Mapping).
  Component,
  /// The Euclidean norm of the field's world value, all components.
  Magnitude,
  /// A component of the world gradient of a component: d value_c / d x_d. Mapping::Identity alone.
  GradientComponent,
  /// The Euclidean norm of the world gradient of a component. Mapping::Identity alone.
  GradientMagnitude,
  /// det J, J = d Phi / d xi in world units: volume per volume of the reference shape.
  Jacobian
};

struct RangeQuestion
{
  Quantity quantity = Quantity::Component;
  const Field* field = nullptr; ///< unless Quantity::Jacobian
  int component = 0;            ///< of the field
  int direction = 0;            ///< of GradientComponent: x, y, z
};

/// Whether RangeOf supports the question. It does not for gradients of mapped fields (H(curl),
/// H(div), densities), which need second derivatives of the map, for gradients of expressions, and
/// for expressions with normals or jumps.
bool IsAnswerable(const RangeQuestion& question);
/// Throws Unsupported with the reason where IsAnswerable is false.
void RequireAnswer(const RangeQuestion& question);

struct RangeEffort
{
  /// The largest distance of the outer ends from attained values, relative to the attained range;
  /// 0.0 < tolerance.
  double tolerance = 1e-3;
  int boxes = 2000; ///< looked at, per element
};

/// The cube in eta: the whole element.
inline constexpr Box3 kWholeElement{ Vec3(-1.0), Vec3(1.0) };

/// A quantity of one element over a box of eta, ready for a search by RangeOf or by a search of
/// several elements together.
class ElementRange
{
public:
  /// Throws Unsupported as RequireAnswer. `part` must lie in the cube and not be empty. The views
  /// must outlive the object.
  ElementRange(
    const Mesh& mesh, int element, const RangeQuestion& question, const Box3& part = kWholeElement);
  /// False where a coefficient of the field is NaN or infinite; then no range is known.
  [[nodiscard]] bool IsFinite() const { return quantity_->IsFinite(); }
  /// The function, and the boxes that cover the part, in units of 2^Exponent().
  [[nodiscard]] const RangeFunction& Function() const { return *quantity_; }
  void ForEachBox(const std::function<void(RangeBox)>& visit) const;
  /// Starts the search with these boxes. `known` as RangeSearch takes it, in these units.
  [[nodiscard]] std::unique_ptr<RangeSearch> Begin(
    const Interval& known = CertifiedRange{}.attained) const;
  [[nodiscard]] int Exponent() const { return quantity_->Exponent(); }

private:
  Box3 Part;
  std::unique_ptr<const ElementQuantity> quantity_;
};

/// The range of a quantity over an element, or over a part of it given as a box in eta (see
/// TensorToReference). It belongs to the functions that the stored coefficients define, exactly;
/// the mesh's uncertainty (how far the true map may be from the stored one) is not included.
///
/// Enclosures tighten quadratically: with half the width of a box, the distance of the outer ends
/// from the attained ones is a quarter, until the bound of rounding errors remains, some 1e-13 of
/// the range of a resolved field. `met` is false where the budget of boxes or 64 MiB of memory is
/// exhausted first. Where det J may vanish, gradients and mapped values are not bounded, and the
/// outer ends are infinite. In a pyramid's Tensor form derivatives are those of the function closed
/// at the apex (PieceForm.h); where that is not the stored one up to rounding, they are not
/// bounded.
CertifiedRange RangeOf(const Mesh& mesh, int element, const RangeQuestion& question,
  const RangeEffort& effort = {}, const Box3& part = kWholeElement);

/// value times 2^exponent, rounded outwards.
Interval Scaled(const Interval& value, int exponent);
CertifiedRange Scaled(const CertifiedRange& range, int exponent);
} // namespace pixelexact
