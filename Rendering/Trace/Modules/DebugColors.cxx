// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/DebugColors.h"

#include "Core/Location/Owners.h"

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

enum JumpColor : std::uint8_t
{
  kNoFace,
  kContinuous,
  kSmallJump,
  kLargestJump
};
constexpr ColorMeaning kJumps[] = {
  { "no face between elements", "pale grey", { 225, 225, 225, 255 } },
  { "continuous, up to rounding", "light blue", { 168, 212, 240, 255 } },
  { "small jumps", "yellow", { 240, 228, 66, 255 } },
  { "the largest jump", "dark purple", { 75, 0, 80, 255 } },
};

/// Colours each sample by `colorAt`; null leaves it transparent.
template <class ColorAt>
void PaintEach(SampleBuffers& samples, std::size_t begin, std::size_t end, const ColorAt& colorAt)
{
  constexpr Rgba kTransparent{};
  for (std::size_t i = begin; i < end; ++i)
  {
    const Rgba* color = colorAt(i);
    std::ranges::copy(color ? *color : kTransparent, &samples.color[4 * i]);
  }
}
} // namespace

std::span<const ColorMeaning> CoverageColors::Legend()
{
  return kCoverage;
}

Buffer CoverageColors::Needs() const
{
  return Buffer::Coverage;
}

void CoverageColors::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  PaintEach(samples, begin, end,
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

Buffer ValidityColors::Needs() const
{
  return Buffer::Element | Buffer::Verdict;
}

void ValidityColors::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  PaintEach(samples, begin, end,
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

std::span<const ColorMeaning> JumpColors::Legend()
{
  return kJumps;
}

Buffer JumpColors::Needs() const
{
  return Buffer::Jump | Buffer::Verdict;
}

Rgba JumpColors::ColorOf(double jump) const
{
  if (std::isnan(jump) || jump == 0.0)
  {
    return kJumps[std::isnan(jump) ? kNoFace : kContinuous].color;
  }
  // The ramp passes vermilion, so that its middle differs from both ends.
  const std::array<Rgba, 3> ramp{ kJumps[kSmallJump].color, Rgba{ 213, 60, 0, 255 },
    kJumps[kLargestJump].color };
  const double part = 2.0 * std::min(jump / Largest, 1.0);
  const std::size_t first = part < 1.0 ? 0 : 1;
  Rgba color{};
  for (std::size_t c = 0; c < color.size(); ++c)
  {
    color[c] = static_cast<std::uint8_t>(std::lround(
      std::lerp(ramp[first][c], ramp[first + 1][c], part - static_cast<double>(first))));
  }
  return color;
}

ColorMap JumpColors::Map() const
{
  return [own = *this](std::span<const double> jumps, std::uint8_t* rgba)
  {
    for (std::size_t i = 0; i < jumps.size(); ++i)
    {
      std::ranges::copy(own.ColorOf(jumps[i]), rgba + 4 * i);
    }
  };
}

void JumpColors::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  Rgba color{};
  PaintEach(samples, begin, end,
    [&](std::size_t i) -> const Rgba*
    {
      if (samples.verdict[i] == kNothingPixel)
      {
        return nullptr;
      }
      color = samples.verdict[i] == kExactPixel ? ColorOf(samples.jump[i]) : kUnknown;
      return &color;
    });
}

UndecidedColors::UndecidedColors(std::vector<ColorMap> maps, const Rgba& color)
  : Maps(std::move(maps))
  , Color(color)
{
}

Buffer UndecidedColors::Needs() const
{
  return Buffer::Value | Buffer::Verdict | Buffer::Enclosure |
    (Maps.size() > 1 ? Buffer::Layer : Buffer::None);
}

template <class Visit>
void UndecidedColors::Find(
  const SampleBuffers& samples, std::size_t begin, std::size_t end, const Visit& visit) const
{
  for (std::size_t i = begin; i < end; ++i)
  {
    if (samples.verdict[i] != static_cast<std::uint8_t>(PixelVerdict::Exact) ||
      !std::isfinite(samples.value[i]))
    {
      continue;
    }
    const std::array values{ samples.value[i], samples.valueLower[i], samples.valueUpper[i] };
    std::array<Rgba, 3> colors;
    Maps[Maps.size() > 1 ? samples.layer[i] : 0](values, colors[0].data());
    if (colors[0] != colors[1] || colors[0] != colors[2])
    {
      visit(i);
    }
  }
}

std::int64_t UndecidedColors::Count(const SampleBuffers& samples) const
{
  std::int64_t count = 0;
  Find(samples, 0, samples.Size(), [&](std::size_t) { ++count; });
  return count;
}

void UndecidedColors::Paint(SampleBuffers& samples, std::size_t begin, std::size_t end) const
{
  Find(
    samples, begin, end, [&](std::size_t i) { std::ranges::copy(Color, &samples.color[4 * i]); });
}
} // namespace pixelexact
