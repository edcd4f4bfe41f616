// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Drawing/Canvas.h"

#include "Core/Math/Vec.h"
#include "Trace/Frame.h"

#include <optional>
#include <vector>

namespace pixelexact
{
struct Shot;

/// Where a cut is in the mesh: lines of the mesh's box or of its boundary, over the picture.
///
/// - Box: its edges, where no cut-surface is in front of them.
/// - Boundary: where the boundary, traced for itself, ends before the background or before parts of
///   itself that lie further away, and where its normal turns by 30 degrees or more from one pixel
///   to the next. What the boundary hides has no lines. To half a pixel, in pictures of more than
///   4 million to a whole one. Lines between pixels that are unknown are not drawn.
class MeshOutline
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsAsked() const { return Kind != Of::Nothing; }
  /// The buffers of centres that Draw reads.
  [[nodiscard]] Buffer Needs() const;
  /// Points that a camera must see to see all of it.
  [[nodiscard]] std::vector<Vec3> Points(const Shot& shot) const;
  /// On the image of a frame that is painted. Throws Error where the mesh has no boundary.
  void Draw(const Shot& shot, Frame& frame) const;
  /// The same lines in the picture's pixels. Throws as Draw.
  [[nodiscard]] std::vector<std::vector<CanvasPoint>> Paths(
    const Shot& shot, const Frame& frame) const;
  [[nodiscard]] double LineWidth() const { return Width; }
  [[nodiscard]] Rgba LineColor() const;

private:
  enum class Of
  {
    Nothing,
    Box,
    Boundary
  };
  Of Kind = Of::Nothing;
  double Width = 0.0;
  std::vector<double> Color{ 0.0, 0.0, 0.0 };
};
} // namespace pixelexact
