// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/PictureErrors.h"
#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <cstdint>
#include <vector>

// Pictures of values and of errors; RGB, three bytes a pixel, lower left first.
namespace pixelexact
{
/// Values in the map's colours, contours in black, unknown pixels in magenta, the background where
/// there is nothing.
[[nodiscard]] std::vector<std::uint8_t> PaintValues(
  const Picture& picture, const ColorMap& map, const Rgba& background);

/// The error's range in PaintErrors, over the values' range.
inline constexpr std::array<double, 2> kPaintedErrors{ 1e-8, 1.0 };

/// The logarithm of |error| over `range` by `map`, which spans kPaintedErrors; missing values in
/// magenta, invented ones in cyan.
[[nodiscard]] std::vector<std::uint8_t> PaintErrors(const Picture& truth, const Picture& picture,
  const std::array<double, 2>& range, const ColorMap& map, const Rgba& background);
} // namespace pixelexact
