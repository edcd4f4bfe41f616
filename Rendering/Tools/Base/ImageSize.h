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
/// Of prints, where sizes are lengths and nothing else is said.
inline constexpr double kUsualDpi = 300.0;
/// The pixels of a size that is a length, with so many to an inch; others stay. Throws UsageError.
ImageSize AtDpi(const ImageSize& size, double dpi);
/// The value of an option. Throws UsageError for a text that is no size.
ImageSize ParseImageSize(const std::string& option, const std::string& text);
} // namespace pixelexact
