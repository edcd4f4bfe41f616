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
/// Of a text, in pixels.
struct LabelSize
{
  double width = 0.0;
  double height = 0.0;
};

/// Where a contour's label goes.
struct ContourPlace
{
  std::size_t layer = 0;
  std::size_t value = 0; ///< its number, in ascending order
  glm::dvec2 centre{};   ///< in the image, in pixels
  double angle = 0.0;    ///< of the text, anticlockwise from across, -90 to 90 degrees
};

/// Places on a frame's contours for labels: where the contour is straight along the text, to
/// kBent of its height, no other contour comes as near as half its height, and the text is kBorder
/// pixels within the image; straightest first, and apart: two texts do not touch, and those of one
/// value are kApart of the image's shorter side from each other. A contour may have none.
///
/// Reads Value, Verdict and Layer of the frame's centres and, to tell sheets of curved surfaces
/// apart, Position and Normal where there are any. `sizes`: by layer and value. `undecided`:
/// whether there are lines in undecided pixels, too.
[[nodiscard]] std::vector<ContourPlace> PlaceLabels(const Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const std::vector<std::vector<LabelSize>>& sizes,
  bool undecided);
} // namespace pixelexact
