// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/ColorMapping.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pixelexact
{
namespace
{
/// The end of the run of equal bytes that begins at `begin`.
std::size_t EndOfRun(const std::vector<std::uint8_t>& bytes, std::size_t begin, std::size_t end)
{
  const std::uint8_t* first = bytes.data() + begin;
  // Usually all bytes are equal.
  if (std::memcmp(first, first + 1, end - begin - 1) == 0)
  {
    return end;
  }
  return begin +
    static_cast<std::size_t>(std::find_if(first, bytes.data() + end,
                               [first](std::uint8_t byte) { return byte != *first; }) -
      first);
}
} // namespace

ColorMap SolidColor(const Rgba& color)
{
  return [color](std::span<const double> values, std::uint8_t* rgba)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      rgba = std::ranges::copy(color, rgba).out;
    }
  };
}

ColorMap InBands(ColorMap map, const std::array<double, 2>& range, int bands, bool logarithmic)
{
  const auto scaled = [logarithmic](double value)
  { return logarithmic ? std::log10(value) : value; };
  const double lower = scaled(range[0]);
  const double length = scaled(range[1]) - lower;
  return [map = std::move(map), scaled, logarithmic, lower, length, bands](
           std::span<const double> values, std::uint8_t* rgba)
  {
    std::vector<double> middles(values.begin(), values.end());
    for (double& value : middles)
    {
      const double place = scaled(value);
      if (std::isfinite(place) && length > 0.0)
      {
        const double band =
          std::clamp(std::floor((place - lower) / length * bands), 0.0, bands - 1.0);
        const double middle = lower + (band + 0.5) / bands * length;
        value = logarithmic ? std::pow(10.0, middle) : middle;
      }
    }
    map(middles, rgba);
  };
}

ColorMapping::ColorMapping(ColorMap map, const Rgba& unknown)
  : ColorMapping(std::vector<LayerColors>{ { std::move(map), unknown } })
{
}

ColorMapping::ColorMapping(std::vector<LayerColors> layers)
  : Layers(std::move(layers))
{
}

Buffer ColorMapping::Needs() const
{
  const bool anyReads = std::ranges::any_of(Layers, &LayerColors::readsValues);
  return Buffer::Verdict | (anyReads ? Buffer::Value : Buffer::None) |
    (Layers.size() > 1 ? Buffer::Layer : Buffer::None);
}

void ColorMapping::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  // Consecutive samples with one verdict and layer are mapped together.
  for (std::size_t i = begin; i < end;)
  {
    std::size_t next = EndOfRun(samples.verdict, i, end);
    if (Layers.size() > 1)
    {
      next = EndOfRun(samples.layer, i, next);
    }
    PaintRun(samples, i, next);
    i = next;
  }
}

void ColorMapping::PaintExact(
  const LayerColors& layer, SampleBuffers& samples, std::size_t begin, std::size_t count)
{
  std::uint8_t* const color = &samples.color[4 * begin];
  if (!samples.value.empty())
  {
    layer.map({ &samples.value[begin], count }, color);
    return;
  }
  constexpr std::array<double, 64> kNoValues{};
  for (std::size_t k = 0; k < count; k += kNoValues.size())
  {
    layer.map({ kNoValues.data(), std::min(kNoValues.size(), count - k) }, color + 4 * k);
  }
}

void ColorMapping::PaintRun(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  std::uint8_t* const color = &samples.color[4 * begin];
  const std::size_t count = end - begin;
  const auto verdict = static_cast<PixelVerdict>(samples.verdict[begin]);
  if (verdict == PixelVerdict::Nothing)
  {
    std::fill_n(color, 4 * count, std::uint8_t{ 0 });
    return;
  }
  const LayerColors& layer = Layers[Layers.size() > 1 ? samples.layer[begin] : 0];
  if (verdict == PixelVerdict::Exact)
  {
    PaintExact(layer, samples, begin, count);
  }
  else
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      std::ranges::copy(layer.unknown, color + 4 * k);
    }
  }
  for (std::size_t k = 0; layer.opacity < 1.0 && k < count; ++k)
  {
    std::uint8_t& alpha = color[4 * k + 3];
    alpha = static_cast<std::uint8_t>(std::lround(layer.opacity * alpha));
  }
}
} // namespace pixelexact
