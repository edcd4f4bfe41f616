// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Ranges.h"

#include <array>
#include <functional>
#include <optional>

namespace pixelexact
{
/// The query for the range of a field's component, or kMagnitude.
[[nodiscard]] RangeQuestion QuestionOf(const Field& field, int component);

/// Contains all values of a component (or kMagnitude) of a field over a mesh; empty if there is no
/// finite value.
[[nodiscard]] Interval ProvenRange(const Mesh& mesh, const Field& field, int component);

/// The range of a field for colours, in all interfaces. It is proven to contain all values of a
/// component (or kMagnitude) of a field over a mesh. Each end is off an attained value by at most a
/// thousandth of the range, unless the search ends early (2000 boxes for an element whose map
/// folds). Elements with a NaN or infinite coefficient are omitted; none if no elements remain.
/// Throws Error if no bound was found.
[[nodiscard]] std::optional<std::array<double, 2>> FieldRange(const Mesh& mesh, const Field& field,
  int component, const std::function<void(double)>& progress = {});

/// Attained values of a component (or kMagnitude) of a field. All others exceed them by at most a
/// thousandth of the range. For tables of a file's contents; none as above.
[[nodiscard]] std::optional<std::array<double, 2>> AttainedRange(
  const Mesh& mesh, const Field& field, int component);

/// The width of a range of a field's values is within the rounding of one value: 1e-12 of the
/// largest coefficient.
[[nodiscard]] bool IsOneValue(const Field& field, const std::array<double, 2>& range);

/// A range of a field's values, for colours. A range within the rounding of one value, as on an
/// iso-surface of the field, is widened to 1e-6 of the largest coefficient about its middle, so
/// that colours do not show rounding. Other ranges are unchanged.
[[nodiscard]] std::array<double, 2> BeyondRounding(
  const Field& field, const std::array<double, 2>& range);
} // namespace pixelexact
