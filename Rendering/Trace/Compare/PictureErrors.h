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
/// Of each pixel's centre to that of the nearest pixel of a mark, in pixels; infinite where there
/// is none. Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012: exact,
/// in time linear in the pixels.
[[nodiscard]] std::vector<double> DistanceToMarked(
  std::span<const std::uint8_t> pixels, std::uint8_t mark, int width, int height);

/// What a picture says of each pixel, lower-left first.
struct Picture
{
  int width = 0;
  int height = 0;
  std::vector<double> value;         ///< NaN: no answer
  std::vector<std::uint8_t> verdict; ///< PixelVerdict
  std::vector<std::uint8_t> contour; ///< ContourVerdict; empty: not known

  [[nodiscard]] std::size_t Size() const { return value.size(); }
};

/// Of a frame with Value and Verdict, and of the verdicts of a ContourCertifier, or none.
[[nodiscard]] Picture PictureOf(const Frame& frame, std::span<const std::uint8_t> contours);

/// Of values at centres, NaN where nothing is seen, and, for contours, at corners: a pixel is In
/// where a value lies between those at two of its corners, both included. `corners` may be empty.
[[nodiscard]] Picture PictureOf(int width, int height, std::vector<double> centres,
  std::span<const double> corners, std::span<const double> isoValues);

/// How far a picture is from another one that is taken as the truth. Counts are pixels; errors are
/// absolute differences of values.
struct PictureErrors
{
  // Pixels to which the true picture gives a finite value.
  std::int64_t shown = 0;
  std::int64_t compared = 0; ///< of them, those to which the other gives one, too
  std::int64_t missing = 0;  ///< the others: no answer
  std::int64_t invented = 0; ///< that have a value where the truth is that nothing is there
  double largest = 0.0;      ///< of the compared
  double mean = 0.0;
  /// No larger for this part of the shown; a missing value is infinitely far.
  double atShare = 0.0;
  std::int64_t wrongBin = 0; ///< compared ones whose colour bin is another

  // Contours, where both pictures know of them. What is undecided in either counts for nothing.
  bool hasContours = false;
  std::int64_t contourPixels = 0;    ///< that the truth has In
  std::int64_t contourMissed = 0;    ///< of them, with no contour pixel of the other nearby
  std::int64_t contourDisplaced = 0; ///< that are not the other's, but have one nearby
  std::int64_t contourInvented = 0;  ///< the other's, with none of the truth's nearby
  double contourFarthest = 0.0; ///< from one of the truth's to the other's nearest; infinite: none
};

/// Pixels are nearby up to this many pixels from centre to centre.
inline constexpr double kNearbyPixels = 3.0;

/// How pictures are compared.
struct ErrorMeasure
{
  double share = 0.99;           ///< of PictureErrors::atShare, above 0, at most 1
  std::array<double, 2> range{}; ///< of the colour bins
  int bins = 256;                ///< at least 1; values beyond the range are in those at its ends
};

/// Both of one size; else throws Error.
[[nodiscard]] PictureErrors Compare(
  const Picture& truth, const Picture& other, const ErrorMeasure& measure);
} // namespace pixelexact
