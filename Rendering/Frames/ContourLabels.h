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

/// Limits of the labels' font size, in pixels.
struct LabelFont
{
  static constexpr int kSmallest = 6;
  static constexpr int kLargest = 72;
  static constexpr int kDefault = 12;
};

/// Throws Error for a size outside LabelFont's limits.
void RequireLabelSize(int size);

/// The values as texts, with the fewest digits, at least 3, that distinguish them.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<std::string> LabelTexts(
  const std::vector<double>& values);

/// The label of a contour, in the image's pixels.
struct ContourLabel
{
  std::string text;
  double x = 0.0; ///< of the text's centre
  double y = 0.0;
  double angle = 0.0; ///< anticlockwise from horizontal, -90 to 90 degrees
  TextSize size{};    ///< of the text before rotation
  Rgba color{};

  /// Gap between the text and the contour's line, in pixels.
  static constexpr double kGap = 2.0;
};

/// The labels of DrawContourLabels. Throws Error as it does.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<ContourLabel> PlaceContourLabels(
  const Frame& frame, const Camera& camera, const ContourCertifier& contours,
  const ContourLines& lines, int size, const FontChoice& font = {});

/// Writes values along the contours of a frame's image (PlaceLabels), in the contours' colours and
/// in gaps of the lines. The lines must keep the image beneath them (ContourStyle::keepBeneath).
/// Returns the count of labels. Throws Error for a size outside LabelFont's limits, and if FreeType
/// fails.
PIXELEXACTRENDERING_EXPORT int DrawContourLabels(Frame& frame, const Camera& camera,
  const ContourCertifier& contours, const ContourLines& lines, int size,
  const FontChoice& font = {});

/// Draws the labels of a painter that requests them, as a Renderer does.
void DrawLabelsOf(Frame& frame, const Camera& camera, const Painter& painter);
} // namespace pixelexact
