// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Pipeline.h"

#include <array>
#include <functional>

namespace pixelexact
{
/// Appearance of the lines between elements.
struct EdgeStyle
{
  static constexpr double kNarrowest = 0.1;
  static constexpr double kWidest = 32.0;

  double width = 1.5; ///< in pixels, kNarrowest to kWidest
  /// By FaceKind; without kinds, all faces are Interior. Alpha is the line's opacity.
  std::array<Rgba, 4> colors{ Rgba{ 0, 0, 0, 255 }, Rgba{ 0, 0, 0, 255 }, Rgba{ 0, 0, 0, 255 },
    Rgba{ 0, 0, 0, 255 } };

  /// One style for all kinds.
  static EdgeStyle Plain(double width, const Rgba& color);
  /// Interior faces are black, the mesh's boundary blue, hanging faces orange, partly covered faces
  /// purple. Colour-blind readers can distinguish these colours.
  static EdgeStyle ByKind(double width);

  bool operator==(const EdgeStyle&) const = default;
};

/// The kind of an element's face; called from several threads at once.
using KindOfFace = std::function<FaceKind(int element, int face)>;

/// Draws the lines along which the visible surface crosses from one element into another (FaceLines
/// finds them). Lines have a width in pixels; a pixel is painted in proportion to the area that the
/// line covers. Each side of the face gets half of a line's width. If kinds are given and the
/// surface leaves the mesh at its boundary, all of the line is inside. There is no line where the
/// surface ends inside an element, where another layer begins, or along a face on which the surface
/// lies. Of translucent layers the nearest sheet counts. A pixel keeps its opacity.
///
/// Lines fade where an element is less than kFullSize line widths across, and vanish at one width,
/// so that many small elements do not merge into a dark patch.
///
/// Changes only the frame's image; without colours it does nothing. Requests no samples, but traces
/// the scene. Belongs after Antialiasing, which would paint over the lines.
class ElementEdges final : public FrameModule
{
public:
  static constexpr double kFullSize = 4.0;

  /// `kinds` empty: all faces are alike. Throws Error for a width out of range.
  explicit ElementEdges(const EdgeStyle& style, KindOfFace kinds = {});

  [[nodiscard]] SampleNeeds Needs() const override;
  void Begin(int width, int height) override;
  void Process(TileVisit& tile) override;

private:
  EdgeStyle Style;
  KindOfFace Kinds;
};
} // namespace pixelexact
