// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Drawing/Canvas.h"

#include "Trace/Frame.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pixelexact
{
class ShotAppearance;
struct Shot;

/// The dots of a picture: points of a quadrature function with its values.
struct FoundDots
{
  struct Dot
  {
    CanvasPoint at; ///< in the picture
    double value = 0.0;
    Rgba color{};
  };
  std::vector<Dot> dots; ///< the visible ones, the farthest first
  std::string field;
  std::size_t points = 0; ///< of the whole mesh
};

/// Dots at the points where a quadrature function of MFEM has its values, in the colours of the
/// layer that shows it: --dots. A dot has the value at its point, and not that of the surface
/// around it. Points behind a surface or outside of --clip have none.
class FieldDots
{
public:
  void AddTo(CLI::App& command) { Bind(command, "--dots", Asked); }
  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// The buffers of centres that Find reads.
  [[nodiscard]] Buffer Needs() const { return Asked ? Buffer::Depth : Buffer::None; }

  /// The dots of the first layer that shows a quadrature function. A note counts those beyond the
  /// layer's range. Throws Error where no layer does.
  [[nodiscard]] static FoundDots Find(
    const Shot& shot, const Frame& frame, const ShotAppearance& appearance);
  /// Draws the dots on the picture of this height, whose lower left corner is the canvas's origin.
  static void Draw(Canvas& canvas, const FoundDots& found, int height);

private:
  bool Asked = false;
};
} // namespace pixelexact
