// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

namespace pixelexact
{
/// An image size "WxH", in pixels; or in millimetres or inches, "85x60mm", "3.5x2.5in". A width
/// alone, "1200" or "85mm", leaves the height to the layout of a figure.
struct ImageSize
{
  int width = 1000;
  int height = 1000;                           ///< 0: not given
  std::optional<std::array<double, 2>> inches; ///< as given; none: pixels were
};
/// Points of print in an inch.
inline constexpr double kPointsPerInch = 72.0;

/// A length in a picture: in pixels, or in points of print ("0.5pt"), 72 to an inch, until
/// Resolve makes pixels of them.
struct PixelLength
{
  double value = 0.0;
  bool inPoints = false;
  std::string option = {};           ///< for messages
  std::array<double, 2> limits = {}; ///< in pixels

  /// Converts points to pixels; `dpi`: pixels in an inch, none: the picture has no size in print.
  /// Throws UsageError where it has none, and for lengths outside of the limits.
  void Resolve(const std::optional<double>& dpi);
  /// Throws UsageError for points that were not converted.
  [[nodiscard]] double Pixels() const;
};

/// Pixels in an inch where a size is a length and --dpi is not given.
inline constexpr double kDefaultDpi = 300.0;
/// Converts a size that is a length to pixels; `dpi` is their number in an inch. A size in pixels
/// is returned as it is. Throws UsageError for a size that is too small or too large.
ImageSize AtDpi(const ImageSize& size, double dpi);
/// Reads the value of an option. Throws UsageError for a text that is no size.
ImageSize ParseImageSize(const std::string& option, const std::string& text);
} // namespace pixelexact
