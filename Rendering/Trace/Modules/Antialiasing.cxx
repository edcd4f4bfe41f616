// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/Antialiasing.h"

#include "Core/Base/Error.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
/// Bits of `i` mirrored at the binary point (J. van der Corput, 1935).
double RadicalInverse(int i)
{
  double sum = 0.0;
  for (double digit = 0.5; i > 0; i /= 2, digit *= 0.5)
  {
    sum += i % 2 * digit;
  }
  return sum;
}

/// The colours are one colour up to kAlike; those of transparent pixels always are.
bool AreAlike(const std::uint8_t* a, const std::uint8_t* b)
{
  if (std::abs(a[3] - b[3]) > Antialiasing::kAlike)
  {
    return false;
  }
  const bool shown = a[3] > 0 || b[3] > 0;
  return !shown ||
    std::equal(a, a + 3, b, [](int x, int y) { return std::abs(x - y) <= Antialiasing::kAlike; });
}
} // namespace

Antialiasing::Antialiasing(int samples)
{
  if (samples < 1)
  {
    throw Error("anti-aliasing: " + std::to_string(samples) + " samples a pixel; give at least 1.");
  }
  // Hammersley's set has optimal uniformity in both directions for its size.
  for (int i = 0; i < samples; ++i)
  {
    Offsets.push_back({ (i + 0.5) / samples, RadicalInverse(i) + 0.5 / samples });
  }
}

SampleNeeds Antialiasing::Needs() const
{
  return { .coloredCorners = true };
}

void Antialiasing::Begin(int /*width*/, int /*height*/)
{
  RefinedPixels = 0;
}

void Antialiasing::Process(TileVisit& tile)
{
  const Frame& frame = tile.GetFrame();
  if (frame.color.empty())
  {
    return;
  }
  const TileArea& area = tile.Area();
  const std::vector<std::uint8_t> corners = tile.Image(tile.Corners());
  const int across = area.Width() + 1;
  std::vector<std::array<int, 2>> pixels;
  for (int y = area.y0; y < area.y1; ++y)
  {
    for (int x = area.x0; x < area.x1; ++x)
    {
      const std::uint8_t* own = &frame.color[4 *
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
          static_cast<std::size_t>(x))];
      const auto at = [&](int dx, int dy) {
        return &corners[4 *
          static_cast<std::size_t>((y - area.y0 + dy) * across + x - area.x0 + dx)];
      };
      if (!AreAlike(own, at(0, 0)) || !AreAlike(own, at(1, 0)) || !AreAlike(own, at(0, 1)) ||
        !AreAlike(own, at(1, 1)))
      {
        pixels.push_back({ x, y });
      }
    }
  }
  RefinedPixels += static_cast<std::int64_t>(pixels.size());
  // Traces about 4096 samples at a time.
  const std::size_t some = std::max<std::size_t>(1, 4096 / Offsets.size());
  for (std::size_t first = 0; first < pixels.size(); first += some)
  {
    Refine(tile, std::span(pixels).subspan(first, std::min(some, pixels.size() - first)));
  }
}

void Antialiasing::Refine(TileVisit& tile, std::span<const std::array<int, 2>> pixels)
{
  std::vector<ImagePosition> positions;
  for (const auto& [x, y] : pixels)
  {
    for (const auto& [dx, dy] : Offsets)
    {
      positions.push_back({ x + dx, y + dy });
    }
  }
  SampleBuffers samples = tile.Trace(positions, tile.ColorNeeds());
  const std::vector<std::uint8_t> image = tile.Image(samples);
  Frame& frame = tile.GetFrame();
  const std::uint8_t* color = image.data();
  for (const auto& [x, y] : pixels)
  {
    std::array<double, 4> sum{};
    for (std::size_t k = 0; k < Offsets.size(); ++k, color += 4)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += color[c] * (color[3] / 255.0);
      }
      sum[3] += color[3] / 255.0;
    }
    std::uint8_t* own = &frame.color[4 *
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
        static_cast<std::size_t>(x))];
    for (std::size_t c = 0; c < 3; ++c)
    {
      own[c] = sum[3] > 0.0 ? static_cast<std::uint8_t>(std::lround(sum[c] / sum[3])) : 0;
    }
    own[3] =
      static_cast<std::uint8_t>(std::lround(255.0 * sum[3] / static_cast<double>(Offsets.size())));
  }
}
} // namespace pixelexact
