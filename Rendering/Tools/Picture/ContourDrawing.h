// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/ContourLabels.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ContourLines.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
class ColorOptions;
class ContourOptions;
class Looks;
struct FontChoice;
struct Shot;

/// What there is to tell of contours.
struct FoundContours
{
  std::vector<std::vector<double>> values; ///< by layer, in ascending order
  std::size_t outside = 0; ///< of them, outside of the values at centres of their layer's pixels
  ContourCounters pixels;
  std::optional<int> labels; ///< written, where they were asked for
  bool interior = false;     ///< whether loops inside of pixels were looked for
  /// Whether a number of values was asked for where a surface shows one value, up to rounding.
  bool ofOneValue = false;
};

/// The contours of a shot.
class ContourDrawing
{
public:
  /// Of a frame whose samples are there. `bounds`: as of ContourCertifier. Throws Error as
  /// RangeOfLayer.
  ContourDrawing(const ContourOptions& options, const ColorOptions& colors, const Shot& shot,
    const Looks& looks, const Frame& frame, std::shared_ptr<ContourBounds> bounds = nullptr);
  ContourDrawing(const ContourDrawing&) = delete;
  ContourDrawing& operator=(const ContourDrawing&) = delete;

  /// Last, so that nothing is drawn over them. What is pointed to lives here. `lines`: whether they
  /// are drawn, or told apart alone.
  void AddTo(Pipeline& pipeline, bool lines = true);
  /// Values of a layer, in ascending order, and the colour of one.
  [[nodiscard]] const std::vector<double>& ValuesOf(std::size_t layer) const
  {
    return Certifier->Values()[layer];
  }
  [[nodiscard]] const Rgba& ColorOf(std::size_t layer, std::size_t value) const
  {
    return Lines->ColorOf(layer, value);
  }

  /// On the image of a frame that went through the pipeline.
  void DrawLabels(const Shot& shot, const FontChoice& font, Frame& frame);
  /// The same labels, for others to draw; none where they were not asked for.
  std::vector<ContourLabel> PlaceLabels(
    const Shot& shot, const FontChoice& font, const Frame& frame);

  /// What was found in a frame that went through the pipeline.
  [[nodiscard]] FoundContours Found(const Frame& frame) const;
  [[nodiscard]] const ContourCounters& Pixels() const { return Certifier->Counters(); }
  /// A ContourVerdict for each pixel.
  [[nodiscard]] const std::vector<std::uint8_t>& Verdicts() const { return Certifier->Verdicts(); }

private:
  std::optional<ColorMapping> InPlace; ///< of the surface's colours
  bool Interior = false;
  bool OfOneValue = false;
  std::optional<ContourCertifier> Certifier;
  std::optional<ContourLines> Lines;
  std::optional<int> LabelHeight;
  int Labels = 0;
};
} // namespace pixelexact
