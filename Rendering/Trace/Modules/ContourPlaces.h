// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Modules/ContourCertifier.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace pixelexact
{
/// Size of a text, in pixels.
struct LabelSize
{
  double width = 0.0;
  double height = 0.0;
};

/// Place of a contour's label.
struct ContourPlace
{
  std::size_t layer = 0;
  std::size_t value = 0; ///< number of the iso-value, in ascending order
  glm::dvec2 centre{};   ///< in the image, in pixels
  double angle = 0.0;    ///< of the text, anticlockwise from horizontal, -90 to 90 degrees
};

/// Finds places for labels on a frame's contours. At a place, the contour deviates from a straight
/// line by at most kBent of the text's height. No other contour is within half the text's height.
/// The text lies at least kBorder pixels inside the image. Straighter places precede others. Texts
/// do not touch each other, and those of one value are kApart of the image's shorter side apart. A
/// contour may get no place.
///
/// Reads Value, Verdict and Layer of the frame's centres. Reads Position and Normal, if the frame
/// has them, to separate the sheets of curved surfaces. `sizes`: by layer and value. `undecided`:
/// Undecided pixels have lines.
[[nodiscard]] std::vector<ContourPlace> PlaceLabels(const Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const std::vector<std::vector<LabelSize>>& sizes,
  bool undecided);
} // namespace pixelexact
