// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"

#include <cmath>
#include <cstdint>

namespace pixelexact
{
/// `part`, 0 to 1, of a colour over a pixel of straight alpha.
inline void BlendOver(const Rgba& color, double part, std::uint8_t* pixel)
{
  const double above = part * color[3] / 255.0;
  const double below = (1.0 - above) * pixel[3] / 255.0;
  const double alpha = above + below;
  for (std::size_t c = 0; c < 3 && alpha > 0.0; ++c)
  {
    pixel[c] =
      static_cast<std::uint8_t>(std::lround((above * color[c] + below * pixel[c]) / alpha));
  }
  pixel[3] = static_cast<std::uint8_t>(std::lround(255.0 * alpha));
}
} // namespace pixelexact
