// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ElementOutlines.h"

#include "Trace/TileVisit.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Element and layer of a sample; -1 and kNoLayer if it is not Exact.
struct Seen
{
  std::int64_t element = -1;
  std::uint8_t layer = kNoLayer;

  Seen(const SampleBuffers& samples, std::size_t i)
  {
    if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      element = samples.element[i];
      layer = samples.layer[i];
    }
  }
  bool operator==(const Seen&) const = default;
};
} // namespace

ElementOutlines::ElementOutlines(const Rgba& color)
  : Color(color)
{
}

SampleNeeds ElementOutlines::Needs() const
{
  constexpr Buffer kNeeded = Buffer::Element | Buffer::Verdict | Buffer::Layer;
  return { .centres = kNeeded, .corners = kNeeded };
}

void ElementOutlines::Begin(int /*width*/, int /*height*/) {}

void ElementOutlines::Process(TileVisit& tile)
{
  Frame& frame = tile.GetFrame();
  if (frame.color.empty())
  {
    return;
  }
  const TileArea& area = tile.Area();
  const SampleBuffers& corners = tile.Corners();
  const auto across = static_cast<std::size_t>(corners.width);
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x)
    {
      const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
        static_cast<std::size_t>(x);
      const std::size_t lower =
        static_cast<std::size_t>(y - area.y0) * across + static_cast<std::size_t>(x - area.x0);
      const Seen centre(frame.centres, pixel);
      const std::array around{ Seen(corners, lower), Seen(corners, lower + 1),
        Seen(corners, lower + across), Seen(corners, lower + across + 1) };
      const bool shown = centre.element >= 0 &&
        std::ranges::none_of(around, [](const Seen& seen) { return seen.element < 0; });
      if (shown && std::ranges::count(around, centre) < 4)
      {
        std::ranges::copy(Color, &frame.color[4 * pixel]);
      }
    }
  }
}
} // namespace pixelexact
