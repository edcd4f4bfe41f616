// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Resolve.h"
#include "Trace/Modules/Antialiasing.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Modules/ContourLines.h"
#include "Trace/Modules/DebugColors.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/ElementOutlines.h"
#include "Trace/Modules/Lighting.h"
#include "Trace/Pipeline.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
class ContourBounds;
struct View;
class VolumeDrawing;

/// The lines that a pipeline draws in addition to colours.
struct Drawn
{
  bool edges = true;    ///< between elements
  bool contours = true; ///< pixels are classified even if false
};

/// Creates pipelines from the appearance of a view: colours, lights, undecided pixels,
/// anti-aliasing, lines between elements, contours, a volume, in this order.
class Painter
{
public:
  /// `resolved`: of the view. `bounds`: bounds of the fields that contours keep between frames;
  /// null: they are computed for each frame. Throws Error for values and widths that cannot be
  /// drawn, if anti-aliasing would mix the colour of undecided pixels, and for what a volume
  /// excludes.
  Painter(const View& view, const ResolvedAppearance& resolved,
    std::shared_ptr<ContourBounds> bounds = nullptr);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// The pipeline points to members of this object.
  [[nodiscard]] Pipeline MakePipeline(const Drawn& drawn = {});

  /// The classified pixels; null without contours.
  [[nodiscard]] const ContourCertifier* Contours() const
  {
    return Certifier ? &*Certifier : nullptr;
  }
  [[nodiscard]] const ContourLines* Lines() const { return lines_ ? &*lines_ : nullptr; }
  /// The height of labels on the frame, in pixels; none: no labels.
  [[nodiscard]] const std::optional<int>& Labels() const { return labels_; }
  /// The module that paints pixels whose colour is not proven; null if there is none.
  [[nodiscard]] const UndecidedColors* Undecided() const { return Unproven.get(); }
  /// The module that draws the view's volume; null if there is none.
  [[nodiscard]] const VolumeDrawing* Volumes() const { return volume_.get(); }
  /// Count of the last frame's pixels that were smoothed.
  [[nodiscard]] std::int64_t Refined() const { return Smooth ? Smooth->Refined() : 0; }

private:
  void MakeContours(
    const View& view, const ResolvedAppearance& resolved, std::shared_ptr<ContourBounds> bounds);

  std::optional<ColorMapping> Colors;
  // Not std::optional, for which g++ 14 reports a false use before initialisation.
  std::unique_ptr<Lighting> Lights;
  std::unique_ptr<UndecidedColors> Unproven;
  std::optional<Antialiasing> Smooth;
  std::optional<ElementEdges> Edges;
  std::optional<ElementOutlines> Outlines;
  std::optional<ContourCertifier> Certifier;
  std::optional<ContourLines> lines_;
  std::optional<int> labels_;
  std::unique_ptr<VolumeDrawing> volume_;
};

/// The buffers of centres that Resolve, a Painter and labels read. `afterwards`: the frame is
/// painted in a second pass, and keeps the buffers that make this pass faster.
[[nodiscard]] Buffer NeedsOf(const View& view, bool afterwards = true);
} // namespace pixelexact
