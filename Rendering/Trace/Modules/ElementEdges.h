// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceKind.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Pipeline.h"

#include <array>
#include <functional>

namespace pixelexact
{
/// How the lines between elements look.
struct EdgeStyle
{
  static constexpr double kNarrowest = 0.1;
  static constexpr double kWidest = 32.0;

  double width = 1.5; ///< in pixels, kNarrowest to kWidest
  /// By FaceKind; where kinds are not told, that of Interior. Alpha is the line's opacity.
  std::array<Rgba, 4> colors{ Rgba{ 0, 0, 0, 255 }, Rgba{ 0, 0, 0, 255 }, Rgba{ 0, 0, 0, 255 },
    Rgba{ 0, 0, 0, 255 } };

  /// All kinds alike.
  static EdgeStyle Plain(double width, const Rgba& color);
  /// Interior faces black, the mesh's boundary blue, hanging faces orange, what is partly covered
  /// purple: colours that the colour-blind tell apart.
  static EdgeStyle ByKind(double width);

  bool operator==(const EdgeStyle&) const = default;
};

/// What lies behind a face of an element; called from several threads at once.
using KindOfFace = std::function<FaceKind(int element, int face)>;

/// Draws the lines along which the surface that is shown crosses from one element into another, of
/// a width in pixels, each pixel by the part of it that the line covers (FaceLines has the places).
/// Lines are half on one side of the face and half on the other; at the mesh's boundary, where
/// kinds are told and the surface leaves the mesh there, all of the line is inside. There is no
/// line where the surface ends within an element or another layer begins, and none along a face on
/// which the surface lies. Of translucent layers the nearest sheet counts. A pixel keeps its
/// opacity.
///
/// Lines fade where an element is less than kFullSize line widths across, and are gone at one
/// width: many small elements would else be one dark patch.
///
/// The frame's image alone changes; without colours it does nothing. It asks for no samples, but
/// for the scene. Belongs after Antialiasing, which would paint over the lines.
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
