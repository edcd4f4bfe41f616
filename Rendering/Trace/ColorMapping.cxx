// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/ColorMapping.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pixelexact
{
ColorMapping::ColorMapping(ColorMap map, std::array<std::uint8_t, 4> unknownColor)
  : Map(std::move(map))
  , UnknownColor(unknownColor)
{
}

SampleNeeds ColorMapping::Needs() const
{
  return { Buffer::Value | Buffer::Verdict, Buffer::None };
}

void ColorMapping::Process(Frame& frame) const
{
  const auto width = static_cast<std::size_t>(frame.width);
  frame.color.assign(4 * width * static_cast<std::size_t>(frame.height), 0);
  tbb::parallel_for(0, frame.height,
    [&](int row)
    {
      const std::size_t begin = static_cast<std::size_t>(row) * width;
      const auto* verdict = &frame.centres.verdict[begin];
      std::uint8_t* color = &frame.color[4 * begin];
      // Runs of exact pixels go through the map together.
      for (std::size_t i = 0; i < width;)
      {
        std::size_t end = i + 1;
        while (end < width && verdict[end] == verdict[i])
        {
          ++end;
        }
        if (verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
        {
          Map({ &frame.centres.value[begin + i], end - i }, color + 4 * i);
        }
        else if (verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Unknown))
        {
          for (std::size_t k = i; k < end; ++k)
          {
            std::ranges::copy(UnknownColor, color + 4 * k);
          }
        }
        i = end;
      }
    });
}
} // namespace pixelexact
