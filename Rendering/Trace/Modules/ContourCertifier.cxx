// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ContourCertifier.h"

#include "Core/Base/Error.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
void ContourCounters::Add(const ContourCounters& other)
{
  in += other.in;
  out += other.out;
  undecided += other.undecided;
  jumps += other.jumps;
}

ContourCertifier::ContourCertifier(std::vector<std::vector<double>> values)
  : IsoValues(std::move(values))
{
  for (std::vector<double>& ofLayer : IsoValues)
  {
    if (!std::ranges::all_of(ofLayer, [](double value) { return std::isfinite(value); }))
    {
      throw Error("contours: an iso-value is not finite; give finite numbers.");
    }
    std::ranges::sort(ofLayer);
  }
}

SampleNeeds ContourCertifier::Needs() const
{
  return { .corners = Buffer::Value | Buffer::Verdict | Buffer::Layer };
}

void ContourCertifier::Begin(int width, int height)
{
  Width = width;
  Pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
    static_cast<std::uint8_t>(ContourVerdict::Out));
  Counted = {};
}

void ContourCertifier::Process(TileVisit& tile)
{
  const TileArea& area = tile.Area();
  const SampleBuffers& corners = tile.Corners();
  const auto across = static_cast<std::size_t>(area.Width()) + 1;
  ContourCounters counters;
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x)
    {
      const std::size_t first =
        static_cast<std::size_t>(y - area.y0) * across + static_cast<std::size_t>(x - area.x0);
      const std::array<std::size_t, 4> at{ first, first + 1, first + across, first + across + 1 };
      bool in = false;
      for (const double value : IsoValues.empty() ? std::vector<double>{} : IsoValues.front())
      {
        bool below = false;
        bool above = false;
        for (const std::size_t i : at)
        {
          below = below || corners.value[i] <= value;
          above = above || corners.value[i] >= value;
        }
        in = in || (below && above);
      }
      (in ? counters.in : counters.out) += 1;
      Pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
        static_cast<std::size_t>(x)] =
        static_cast<std::uint8_t>(in ? ContourVerdict::In : ContourVerdict::Out);
    }
  }
  const std::lock_guard lock(CountersMutex);
  Counted.Add(counters);
}
} // namespace pixelexact
