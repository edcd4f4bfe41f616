// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

namespace pixelexact
{
/// An image size "WxH", in pixels; or in millimetres or inches, "85x60mm", "3.5x2.5in".
struct ImageSize
{
  int width = 1000;
  int height = 1000;
  std::optional<std::array<double, 2>> inches; ///< as given; none: pixels were
};
/// Pixels in an inch where a size is a length and --dpi is not given.
inline constexpr double kDefaultDpi = 300.0;
/// Converts a size that is a length to pixels; `dpi` is their number in an inch. A size in pixels
/// is returned as it is. Throws UsageError for a size that is too small or too large.
ImageSize AtDpi(const ImageSize& size, double dpi);
/// Reads the value of an option. Throws UsageError for a text that is no size.
ImageSize ParseImageSize(const std::string& option, const std::string& text);
} // namespace pixelexact
