// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Appearance.h"
#include "Trace/Appearance/Resolve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The values at the ends of colour maps.
namespace pixelexact
{
/// Parses "cut", "field" or "all", each optionally after "symmetric-", "symmetric", two numbers
/// separated by `separator`, or two percentages. Throws UsageError.
RangeRule ReadRange(const std::string& option, const std::string& text, char separator);

/// Pixels whose value, on any sheet, the map of its layer does not show as what it is.
struct PixelsBeyond
{
  std::int64_t below = 0; ///< the first end
  std::int64_t above = 0; ///< the last one
  /// Number of values without a logarithm, which get the colour of NaN and are not counted in
  /// `below`.
  std::int64_t noLogarithm = 0;
  std::array<double, 2> noLogarithmRange{}; ///< of these
};

/// `ranges`: by layer; none: it is painted in one colour.
PixelsBeyond CountBeyond(const Frame& frame, const std::vector<ValueRange>& ranges, bool logarithm);
} // namespace pixelexact
