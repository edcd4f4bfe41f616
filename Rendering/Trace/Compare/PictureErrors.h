// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"
#include "Trace/Modules/ContourCertifier.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pixelexact
{
/// Distance of each pixel's centre to that of the nearest pixel with `mark`, in pixels; infinite if
/// there is none. Exact, in time linear in the number of pixels. Source: Felzenszwalb and
/// Huttenlocher, Distance Transforms of Sampled Functions, 2012.
[[nodiscard]] std::vector<double> DistanceToMarked(
  std::span<const std::uint8_t> pixels, std::uint8_t mark, int width, int height);

/// Value and verdicts of each pixel, lower-left first.
struct Picture
{
  int width = 0;
  int height = 0;
  std::vector<double> value;         ///< NaN: no value
  std::vector<std::uint8_t> verdict; ///< PixelVerdict
  std::vector<std::uint8_t> contour; ///< ContourVerdict; empty: unknown

  [[nodiscard]] std::size_t Size() const { return value.size(); }
};

/// From a frame with Value and Verdict, and the verdicts of a ContourCertifier, or none.
[[nodiscard]] Picture PictureOf(const Frame& frame, std::span<const std::uint8_t> contours);

/// From values at centres, NaN where nothing is shown, and, for contours, at corners. A pixel is In
/// if an iso-value lies between the values at two of its corners, inclusively. `corners` may be
/// empty.
[[nodiscard]] Picture PictureOf(int width, int height, std::vector<double> centres,
  std::span<const double> corners, std::span<const double> isoValues);

/// Errors of a picture relative to another one that is taken as the truth. Counts are pixels;
/// errors are absolute differences of values.
struct PictureErrors
{
  // Pixels with a finite value in the true picture.
  std::int64_t shown = 0;
  std::int64_t compared = 0; ///< of them, those with a value in the other picture
  std::int64_t missing = 0;  ///< of them, those without one
  std::int64_t invented = 0; ///< with a value where the true picture shows nothing
  double largest = 0.0;      ///< over the compared pixels
  double mean = 0.0;
  /// Error that this share of the shown pixels does not exceed; a missing value has infinite error.
  double atShare = 0.0;
  std::int64_t wrongBin = 0; ///< compared pixels with another colour bin

  // Contours, if both pictures have them. Pixels that are Undecided in either are not counted.
  bool hasContours = false;
  std::int64_t contourPixels = 0;    ///< In in the true picture
  std::int64_t contourMissed = 0;    ///< of them, with no contour pixel of the other picture nearby
  std::int64_t contourDisplaced = 0; ///< of them, Out in the other picture, with one nearby
  std::int64_t contourInvented = 0;  ///< In in the other picture, with no true one nearby
  double contourFarthest = 0.0;      ///< largest distance from a true one to the other picture's
};

/// Largest distance of the centres of nearby pixels.
inline constexpr double kNearbyPixels = 3.0;

/// Parameters of the comparison.
struct ErrorMeasure
{
  double share = 0.99;           ///< of PictureErrors::atShare, in (0, 1]
  std::array<double, 2> range{}; ///< of the colour bins
  int bins = 256; ///< at least 1; values outside the range are in the first or last bin
};

/// Throws Error if the pictures have different sizes.
[[nodiscard]] PictureErrors Compare(
  const Picture& truth, const Picture& other, const ErrorMeasure& measure);
} // namespace pixelexact
