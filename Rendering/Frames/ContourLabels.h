// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Modules/ContourLines.h"
#include "Views/TextImages.h"

#include <string>
#include <vector>

namespace pixelexact
{
class Painter;

/// Height of labels' font in pixels.
struct LabelFont
{
  static constexpr int kSmallest = 6;
  static constexpr int kLargest = 72;
  static constexpr int kDefault = 12;
};

/// Throws Error for a size out of LabelFont's limits.
void RequireLabelSize(int size);

/// The values as texts, in as few digits, from 3, as tell them apart.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<std::string> LabelTexts(
  const std::vector<double>& values);

/// A value beside its contour, in the image's pixels.
struct ContourLabel
{
  std::string text;
  double x = 0.0; ///< of its middle
  double y = 0.0;
  double angle = 0.0; ///< anticlockwise from across, -90 to 90 degrees
  TextSize size{};    ///< of the text, unturned
  Rgba color{};

  /// Between a line that comes near and the text, in pixels.
  static constexpr double kGap = 2.0;
};

/// The labels of DrawContourLabels. Throws as it does.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<ContourLabel> PlaceContourLabels(
  const Frame& frame, const Camera& camera, const ContourCertifier& contours,
  const ContourLines& lines, int size, const FontChoice& font = {});

/// Writes values along the contours that a frame's image shows (PlaceLabels), in their colours, in
/// gaps of the lines: these must keep what is beneath them. Returns how many. Throws Error for a
/// size out of LabelFont's limits, and where no text can be made.
PIXELEXACTRENDERING_EXPORT int DrawContourLabels(Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const ContourLines& lines, int size,
  const FontChoice& font = {});

/// The labels of a painter that has some, as a Renderer draws them.
void DrawLabelsOf(Frame& frame, const Camera& camera, const Painter& painter);
} // namespace pixelexact
