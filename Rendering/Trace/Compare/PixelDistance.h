// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// Of each pixel's centre to that of the nearest pixel of a mark, in pixels; infinite where there
/// is none. Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012: exact,
/// in time linear in the pixels.
[[nodiscard]] std::vector<double> DistanceToMarked(
  std::span<const std::uint8_t> pixels, std::uint8_t mark, int width, int height);
} // namespace pixelexact
