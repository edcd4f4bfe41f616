// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"

#include <array>
#include <functional>
#include <optional>

namespace pixelexact
{
/// For the range of a component (or kMagnitude) of a field.
[[nodiscard]] RangeQuestion QuestionOf(const Field& field, int component);

/// Holds all values of a component (or kMagnitude) of a field over a mesh; empty where it has none
/// that is finite.
[[nodiscard]] Interval ProvenRange(const Mesh& mesh, const Field& field, int component);

/// What all faces mean by a field's range, for colours: it is proven to hold all values of a
/// component (or kMagnitude) of a field over a mesh. The ends lie beyond values that are attained
/// by at most a thousandth of the range, but where the search ends early (2000 boxes for an element
/// whose map folds). Elements with a NaN or infinite coefficient are left out; none where there are
/// no others. Throws Error where no bound was found.
[[nodiscard]] std::optional<std::array<double, 2>> FieldRange(const Mesh& mesh, const Field& field,
  int component, const std::function<void(double)>& progress = {});

/// Values of a component (or kMagnitude) of a field that are attained, with no others beyond them
/// by more than a thousandth of the range, for tables of what a file holds; none as above.
[[nodiscard]] std::optional<std::array<double, 2>> AttainedRange(
  const Mesh& mesh, const Field& field, int component);

/// Whether a range of a field's values is no wider than rounding may make of one value: 1e-12 of
/// the largest coefficient.
[[nodiscard]] bool IsOneValue(const Field& field, const std::array<double, 2>& range);

/// A range of a field's values, for colours: where it is no wider than rounding may make of one
/// value (on an iso-surface of the field), 1e-6 of the largest coefficient about its middle, so
/// that the colours do not show the rounding; else as it is.
[[nodiscard]] std::array<double, 2> BeyondRounding(
  const Field& field, const std::array<double, 2>& range);
} // namespace pixelexact
