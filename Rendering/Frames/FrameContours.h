// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ContourLines.h"
#include "Trace/Scene.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
/// A layer's contours.
struct LayerContours
{
  /// A number of values (RoundValues) over the range of the layer's colours; 0: those below.
  int count = 0;
  std::vector<double> values; ///< in any order
  /// One for each value, or one for all; empty: those that a map gives the values.
  std::vector<Rgba> colors;

  [[nodiscard]] bool Any() const { return count > 0 || !values.empty(); }
  bool operator==(const LayerContours&) const = default;
};

/// The values of a number of contours over a range of colours, the same for all faces: RoundValues.
/// `seen`: the range of the field's values in the picture (ValuesSeen). Where it is one value up to
/// rounding, values that cannot be told from it are left out. `field`: of the layer; null: none.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<double> ContourValuesOver(int count,
  const std::array<double, 2>& range, bool logarithm, const Field* field,
  const std::optional<std::array<double, 2>>& seen);

/// The range of the finite values at the centres of a layer's exact pixels, sheets behind others
/// included; none: there are none.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::optional<std::array<double, 2>> ValuesSeen(
  const Frame& frame, std::size_t layer);

/// How a frame's contours look.
struct ContourLook
{
  ContourStyle style;
  /// The height of labels in pixels; none: no labels. There are none where something is seen
  /// through.
  std::optional<int> labels;
  bool interior = false; ///< see ContourMethod
  double effort = 1.0;   ///< see ContourMethod::SetEffort

  bool operator==(const ContourLook&) const = default;
};

/// The contours of a view's frames: modules and labels.
class FrameContours
{
public:
  /// By layer; `maps` for contours without colours. Throws Error for values, widths and labels
  /// that cannot be drawn, and where a layer has no field.
  void Make(const Scene& scene, const std::vector<LayerContours>& layers,
    const std::vector<ColorMap>& maps, const ContourLook& look);

  /// What is known of the scene's fields, when they or their mesh go.
  void Forget() { Bounds.reset(); }

  /// Last in the pipeline; points to modules here.
  void AddTo(Pipeline& pipeline);
  /// The buffers of centres that labels read.
  [[nodiscard]] Buffer NeedsOfLabels() const;
  /// Writes labels on a frame that went through the pipeline.
  void Finish(Frame& frame, const Camera& camera) const;

  /// What is known of the pixels; null where there are no contours.
  [[nodiscard]] const ContourCertifier* Found() const { return Certifier ? &*Certifier : nullptr; }

private:
  std::shared_ptr<ContourBounds> Bounds;
  std::optional<ContourCertifier> Certifier;
  std::optional<ContourLines> Lines;
  std::optional<int> Labels;
};
} // namespace pixelexact
