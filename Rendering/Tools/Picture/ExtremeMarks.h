// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Core/Integral/SurfaceExtremes.h"
#include "Trace/Frame.h"
#include "Trace/Modules/ColorMapping.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pixelexact
{
class Canvas;
class Projection;
struct ProjectedPoint;
struct Shot;

/// Whether the picture shows a surface in front of a point, or the point is outside of the picture.
/// Reads depths of centres.
[[nodiscard]] bool IsHidden(
  const Frame& frame, const ProjectedPoint& at, const Projection& projection);

/// Marks in a figure at the points where the field of a surface has its minimum and its maximum:
/// --mark-extremes. A point that another surface hides has no mark.
class ExtremeMarks
{
public:
  void AddTo(CLI::App& command) { Bind(command, "--mark-extremes", Asked); }
  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// The buffers of centres that Draw reads.
  [[nodiscard]] Buffer Needs() const { return Asked ? Buffer::Depth : Buffer::None; }

  /// The extremes of each layer that has a field and a surface with polynomials, or faces of
  /// elements. Throws Error where no layer has any, naming the surfaces that do.
  static std::vector<SurfaceExtremes> Find(const Shot& shot);

  /// Draws rings with the values beside them, in the picture of the frame, whose lower left corner
  /// is the canvas's.
  static void Draw(Canvas& canvas, const Shot& shot, const Frame& frame,
    const std::vector<SurfaceExtremes>& all, int font);

private:
  bool Asked = false;
};
} // namespace pixelexact
