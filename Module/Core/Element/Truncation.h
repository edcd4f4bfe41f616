// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/MeshRanges.h"
#include "Core/Element/OwnedExpansion.h"

#include <cstdint>
#include <string>

namespace pixelexact
{
/// A field without the modes of its canonical basis (Space.h) that no space of a lower order has.
/// The basis is orthogonal on the reference shape (that of a pyramid's Tensor form on the cube of
/// eta), so that the result is the best approximation of that order there, in the mean square, of
/// the reference values F. Neighbours are not joined again. Fields of that order or less lose
/// nothing.
class Truncation
{
public:
  /// `order`, 0 to kMaxOrder, of each of the three orders of every element. Copies coefficients;
  /// the field may go afterwards. The field must be valid.
  Truncation(const Field& field, int order);

  /// Views of the kept modes, in the spaces of the lower orders, and of the dropped ones, in the
  /// field's own spaces. The two add up to the field exactly.
  [[nodiscard]] Field Kept() const;
  [[nodiscard]] Field Dropped() const;

  [[nodiscard]] int Order() const { return order_; }
  /// Modes of a component, summed over the elements.
  [[nodiscard]] std::int64_t Modes() const { return AllModes; }
  [[nodiscard]] std::int64_t DroppedModes() const { return Lost; }

private:
  std::string Name;
  Mapping mapping_;
  int order_;
  std::int64_t AllModes = 0;
  std::int64_t Lost = 0;
  OwnedExpansion Low;
  OwnedExpansion High;
};

/// Bounds the change of the field's values, anywhere in the mesh: of a component, from 0, or with
/// component < 0 the Euclidean norm of the change of all components, which also bounds the change
/// of the field's norm. The bound is proven for the stored coefficients; infinite where none was
/// found (RangeOf). An element with a coefficient that is not finite is left out.
[[nodiscard]] double LargestChange(const Mesh& mesh, const Truncation& truncation, int component,
  const RangeProgress& progress = {});
} // namespace pixelexact
