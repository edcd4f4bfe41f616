// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradePictures.h"

#include "Trade/TradeRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr Rgba kMagenta{ 255, 0, 255, 255 };
constexpr Rgba kCyan{ 0, 200, 255, 255 };
constexpr Rgba kBlack{ 0, 0, 0, 255 };
constexpr auto kExact = static_cast<std::uint8_t>(PixelVerdict::Exact);
constexpr auto kNothing = static_cast<std::uint8_t>(PixelVerdict::Nothing);
constexpr auto kUnknown = static_cast<std::uint8_t>(PixelVerdict::Unknown);

void Put(std::vector<std::uint8_t>& rgb, std::size_t pixel, const Rgba& color)
{
  std::copy_n(color.begin(), 3, rgb.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

Rgba At(const std::vector<std::uint8_t>& rgba, std::size_t pixel)
{
  const std::uint8_t* color = &rgba[4 * pixel];
  return { color[0], color[1], color[2], 255 };
}
} // namespace

std::vector<std::uint8_t> PaintValues(
  const Picture& picture, const ColorMap& map, const Rgba& background)
{
  std::vector<std::uint8_t> colors(4 * picture.Size());
  map(picture.value, colors.data());
  std::vector<std::uint8_t> rgb(3 * picture.Size());
  for (std::size_t i = 0; i < picture.Size(); ++i)
  {
    Put(rgb, i,
      picture.verdict[i] == kExact ? At(colors, i)
                                   : (picture.verdict[i] == kUnknown ? kMagenta : background));
    if (!picture.contour.empty() &&
      picture.contour[i] == static_cast<std::uint8_t>(ContourVerdict::In))
    {
      Put(rgb, i, kBlack);
    }
  }
  return rgb;
}

std::vector<std::uint8_t> PaintErrors(const Picture& truth, const Picture& picture,
  const std::array<double, 2>& range, const ColorMap& map, const Rgba& background)
{
  std::vector<double> logarithms(truth.Size());
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const double error = Relative(std::fabs(picture.value[i] - truth.value[i]), range);
    logarithms[i] = std::log10(std::clamp(error, kPaintedErrors[0], kPaintedErrors[1]));
  }
  std::vector<std::uint8_t> colors(4 * truth.Size());
  map(logarithms, colors.data());
  std::vector<std::uint8_t> rgb(3 * truth.Size());
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const bool has = picture.verdict[i] == kExact;
    if (truth.verdict[i] == kExact)
    {
      Put(rgb, i, has ? At(colors, i) : kMagenta);
    }
    else
    {
      Put(rgb, i, has && truth.verdict[i] == kNothing ? kCyan : background);
    }
  }
  return rgb;
}
} // namespace pixelexact
