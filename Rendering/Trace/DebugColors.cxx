// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/DebugColors.h"

#include "Core/Location/Owners.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr Rgba kUnknown{ 255, 0, 255, 255 };

enum CoverageColor : std::uint8_t
{
  kNone,
  kOnce,
  kTwice,
  kMore,
  kUndecided
};
constexpr ColorMeaning kCoverage[] = {
  { "no element", "dark grey", { 64, 64, 64, 255 } },
  { "one, or elements that meet there", "light blue", { 168, 212, 240, 255 } },
  { "two preimages", "orange", { 230, 159, 0, 255 } },
  { "more", "red", { 213, 60, 0, 255 } },
  { "undecided", "magenta", kUnknown },
};

constexpr ColorMeaning kValidity[] = {
  { "valid", "light blue", { 168, 212, 240, 255 } },
  { "inverted", "red", { 213, 60, 0, 255 } },
  { "undecided", "yellow", { 240, 228, 66, 255 } },
};

const Rgba& ColorOf(Coverage coverage, std::int32_t owners)
{
  switch (coverage)
  {
    case Coverage::None:
      return kCoverage[kNone].color;
    case Coverage::Once:
      return kCoverage[kOnce].color;
    case Coverage::Several:
      return kCoverage[owners > 2 ? kMore : kTwice].color;
    default:
      return kCoverage[kUndecided].color;
  }
}

/// Asks `colorAt` for the colour of each pixel; null leaves it transparent.
template <class ColorAt>
void Paint(Frame& frame, const ColorAt& colorAt)
{
  const auto pixels =
    static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
  frame.color.assign(4 * pixels, 0);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (const Rgba* color = colorAt(i))
    {
      std::ranges::copy(*color, &frame.color[4 * i]);
    }
  }
}
} // namespace

std::span<const ColorMeaning> CoverageColors::Legend()
{
  return kCoverage;
}

SampleNeeds CoverageColors::Needs() const
{
  return { Buffer::Coverage, Buffer::None };
}

void CoverageColors::Process(Frame& frame) const
{
  const SampleBuffers& samples = frame.centres;
  Paint(frame,
    [&](std::size_t i)
    {
      return samples.coverage[i] == kNotCovered
        ? nullptr
        : &ColorOf(static_cast<Coverage>(samples.coverage[i]), samples.owners[i]);
    });
}

std::span<const ColorMeaning> ValidityColors::Legend()
{
  return kValidity;
}

ValidityColors::ValidityColors(std::vector<Validity> verdicts)
  : Verdicts(std::move(verdicts))
{
}

SampleNeeds ValidityColors::Needs() const
{
  return { Buffer::Element | Buffer::Verdict, Buffer::None };
}

void ValidityColors::Process(Frame& frame) const
{
  const SampleBuffers& samples = frame.centres;
  Paint(frame,
    [&](std::size_t i) -> const Rgba*
    {
      switch (static_cast<PixelVerdict>(samples.verdict[i]))
      {
        case PixelVerdict::Exact:
        {
          const auto element = static_cast<std::size_t>(samples.element[i]);
          return &kValidity[static_cast<std::size_t>(Verdicts[element])].color;
        }
        case PixelVerdict::Unknown:
          return &kUnknown;
        default:
          return nullptr;
      }
    });
}

UndecidedColors::UndecidedColors(ColorMap map, const Rgba& color)
  : Map(std::move(map))
  , Color(color)
{
}

SampleNeeds UndecidedColors::Needs() const
{
  return { Buffer::Value | Buffer::Verdict | Buffer::Enclosure, Buffer::None };
}

std::vector<std::uint8_t> UndecidedColors::Find(const Frame& frame) const
{
  const SampleBuffers& samples = frame.centres;
  const auto width = static_cast<std::size_t>(frame.width);
  std::vector<std::uint8_t> found(samples.value.size(), 0);
  tbb::parallel_for(0, frame.height,
    [&](int row)
    {
      const std::size_t begin = static_cast<std::size_t>(row) * width;
      std::vector<std::uint8_t> lower(4 * width);
      std::vector<std::uint8_t> upper(4 * width);
      Map({ &samples.valueLower[begin], width }, lower.data());
      Map({ &samples.valueUpper[begin], width }, upper.data());
      for (std::size_t i = 0; i < width; ++i)
      {
        const bool shown =
          samples.verdict[begin + i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
          std::isfinite(samples.value[begin + i]);
        const auto* low = &lower[4 * i];
        const auto* own = &frame.color[4 * (begin + i)];
        found[begin + i] =
          shown && !(std::equal(low, low + 4, &upper[4 * i]) && std::equal(low, low + 4, own)) ? 1
                                                                                               : 0;
      }
    });
  return found;
}

void UndecidedColors::Process(Frame& frame) const
{
  const std::vector<std::uint8_t> found = Find(frame);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i] != 0)
    {
      std::ranges::copy(Color, &frame.color[4 * i]);
    }
  }
}
} // namespace pixelexact
