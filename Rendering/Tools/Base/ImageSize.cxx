// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ImageSize.h"

#include "Base/Command.h"
#include "Base/Numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string_view>

namespace pixelexact
{
namespace
{
// Limits of an image: its pixels and their buffers must be countable in 32 bits.
constexpr std::int64_t kMaxPixels = std::int64_t{ 1 } << 30;

void CheckPixels(double width, double height)
{
  if (!(width >= 1.0 && height >= 1.0 && width * height <= static_cast<double>(kMaxPixels)))
  {
    throw UsageError(fmt::format(
      "--size: {:.0f} x {:.0f} pixels; at least 1 x 1 and at most 2^30 of them", width, height));
  }
}

constexpr const char* kImageSizeForm =
  "WIDTHxHEIGHT or the WIDTH of a figure, in pixels, at least 1, or in mm or in, as 85x60mm";
} // namespace

ImageSize AtDpi(const ImageSize& size, double dpi)
{
  ImageSize pixels = size;
  if (size.inches)
  {
    const double width = std::round((*size.inches)[0] * dpi);
    const double height = std::round((*size.inches)[1] * dpi);
    CheckPixels(width, (*size.inches)[1] > 0.0 ? height : 1.0);
    pixels.width = static_cast<int>(width);
    pixels.height = static_cast<int>(height);
  }
  return pixels;
}

void PixelLength::Resolve(const std::optional<double>& dpi)
{
  if (!inPoints)
  {
    return;
  }
  if (dpi)
  {
    value *= *dpi / kPointsPerInch;
    inPoints = false;
  }
  if (const double pixels = Pixels(); !(pixels >= limits[0] && pixels <= limits[1]))
  {
    throw UsageError(fmt::format("{}: these are {:.3g} pixels here, and {} to {} are possible",
      option, pixels, limits[0], limits[1]));
  }
}

double PixelLength::Pixels() const
{
  if (inPoints)
  {
    throw UsageError(option + ": points have no size in pixels here; give --size in mm or in");
  }
  return value;
}

ImageSize ParseImageSize(const std::string& option, const std::string& text)
{
  ImageSize size;
  std::string_view numbers = text;
  const double perInch = numbers.ends_with("mm") ? 25.4 : numbers.ends_with("in") ? 1.0 : 0.0;
  numbers.remove_suffix(perInch > 0.0 ? 2 : 0);
  const auto cross = numbers.find('x');
  const bool hasHeight = cross != std::string_view::npos;
  const std::string_view width = numbers.substr(0, cross);
  const std::string_view height = hasHeight ? numbers.substr(cross + 1) : std::string_view();
  if (perInch > 0.0)
  {
    std::array<double, 2> lengths{};
    if (!ParseNumber(width, lengths[0]) || !(lengths[0] > 0.0) || !std::isfinite(lengths[0]) ||
      (hasHeight &&
        (!ParseNumber(height, lengths[1]) || !(lengths[1] > 0.0) || !std::isfinite(lengths[1]))))
    {
      Refuse(option, text, kImageSizeForm);
    }
    size.inches = { lengths[0] / perInch, lengths[1] / perInch };
    return AtDpi(size, kDefaultDpi);
  }
  size.height = 0;
  if (!ParseInteger(width, size.width) || size.width < 1 ||
    (hasHeight && (!ParseInteger(height, size.height) || size.height < 1)))
  {
    Refuse(option, text, kImageSizeForm);
  }
  CheckPixels(size.width, hasHeight ? size.height : 1.0);
  return size;
}
} // namespace pixelexact
