// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Look/Resolve.h"
#include "Trace/Look/ViewLook.h"
#include "Trace/Modules/Antialiasing.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Modules/ElementOutlines.h"
#include "Trace/Pipeline.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
class ContourBounds;

/// What a pipeline draws of a look, beside colours.
struct Drawn
{
  bool edges = true;    ///< of elements
  bool contours = true; ///< their lines; pixels are told in any case
};

/// The only one who makes a pipeline of a look: colours, lights, anti-aliasing, lines between
/// elements, contours, in this order.
class Painter
{
public:
  /// Of the look's scene. `bounds`: what is known of the fields for contours, to be used again;
  /// null: it is found out for each frame. Throws Error for values, widths and labels that cannot
  /// be drawn.
  Painter(const ViewLook& look, const Scene& scene, const ResolvedLook& resolved,
    std::shared_ptr<ContourBounds> bounds = nullptr);
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// Points to modules here.
  [[nodiscard]] Pipeline MakePipeline(const Drawn& drawn = {});

  /// What is known of pixels and contours; null where there are none.
  [[nodiscard]] const ContourCertifier* Contours() const
  {
    return Certifier ? &*Certifier : nullptr;
  }
  [[nodiscard]] const ContourLines* Lines() const { return TheLines ? &*TheLines : nullptr; }
  /// The height of labels that are to be written on the frame; none: no labels.
  [[nodiscard]] const std::optional<int>& Labels() const { return TheLabels; }
  /// Pixels of the last frame that were smoothed.
  [[nodiscard]] std::int64_t Refined() const { return Smooth ? Smooth->Refined() : 0; }

private:
  void MakeContours(const ViewLook& look, const Scene& scene, const ResolvedLook& resolved,
    std::shared_ptr<ContourBounds> bounds);

  std::optional<ColorMapping> Colors;
  // Not optional, of which g++ 14 believes that it is reset before it holds anything.
  std::unique_ptr<Lighting> Lights;
  std::optional<Antialiasing> Smooth;
  std::optional<ElementEdges> Edges;
  std::optional<ElementOutlines> Outlines;
  std::optional<ContourCertifier> Certifier;
  std::optional<ContourLines> TheLines;
  std::optional<int> TheLabels;
};

/// The buffers of centres that Resolve, a Painter and labels read, told before there is a frame.
/// `afterwards`: the frame is painted when it has been traced, and is to have what makes that
/// faster.
[[nodiscard]] Buffer NeedsOf(const ViewLook& look, const Scene& scene, bool afterwards = true);
} // namespace pixelexact
