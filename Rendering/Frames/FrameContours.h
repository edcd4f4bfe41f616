// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ContourLines.h"
#include "Trace/Scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
/// A layer's contours.
struct LayerContours
{
  std::vector<double> values; ///< in any order
  /// One for each value, or one for all; empty: those that a map gives the values.
  std::vector<Rgba> colors;

  bool operator==(const LayerContours&) const = default;
};

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
