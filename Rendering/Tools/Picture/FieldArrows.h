// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Drawing/Canvas.h"

#include "Trace/Frame.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
struct Shot;

/// The arrows of a picture. An arrow begins at a pixel's point x and ends at x + scale * v(x).
struct FoundArrows
{
  /// Begin and end in the picture.
  std::vector<std::array<CanvasPoint, 2>> arrows;
  std::string field;
  double scale = 0.0;   ///< length in the world of a vector of length 1
  double longest = 0.0; ///< of the vectors
  /// Pixels of a vector of length 1 across the view, at the depth of the focal point.
  double pixelsPerValue = 0.0;
};

/// Arrows of a vector field at points of the visible surfaces, evenly spaced in the picture:
/// --arrows. Vectors are evaluated at the points, as all values are. Points where nothing is known,
/// or where the vector is not finite, have none.
class FieldArrows
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsAsked() const { return !Name.empty(); }
  [[nodiscard]] const std::string& Field() const { return Name; }
  /// Converts lengths in points, as PixelLength::Resolve.
  void ResolveLengths(const std::optional<double>& dpi);
  /// The buffers of centres that Find reads.
  [[nodiscard]] Buffer Needs() const;

  /// Throws Error where the model has no such field, or it has neither 2 nor 3 components.
  [[nodiscard]] FoundArrows Find(const Shot& shot, const Frame& frame) const;
  /// Draws the arrows on the picture, whose lower left corner is the canvas's origin.
  void Draw(Canvas& canvas, const FoundArrows& found) const;
  /// Draws one arrow with a rim that is visible on all colours.
  void DrawOne(Canvas& canvas, const CanvasPoint& from, const CanvasPoint& to) const;

private:
  [[nodiscard]] double SpacingFor(int width) const;

  std::string Name;
  std::optional<PixelLength> Spacing;
  std::optional<double> Scale;
  PixelLength Width;
  std::vector<double> Color{ 0.0, 0.0, 0.0 };
  bool Tangential = false;
};
} // namespace pixelexact
