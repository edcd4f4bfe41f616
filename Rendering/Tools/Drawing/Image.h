// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// A picture: red, green and blue, with straight alpha where there are four channels; pixels lower
/// left first, row by row.
struct Image
{
  int width = 0;
  int height = 0;
  int channels = 3;
  std::vector<std::uint8_t> pixels;
};
} // namespace pixelexact
