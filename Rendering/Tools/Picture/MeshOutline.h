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

/// Lines of the mesh's box or of its boundary over a picture, which show the cut's position.
///
/// - Box: its edges, where no cut-surface hides them.
/// - Boundary: the silhouette of the boundary, traced without the cut, against the background and
///   against its own parts that are further away, and lines where its normal turns by 30 degrees or
///   more between neighbouring pixels. Hidden lines are left out. Lines are exact to half a pixel,
///   in pictures of more than 4 million pixels to one. Lines between unknown pixels are left out.
/// - Undeformed: the same of the mesh before --warp; the deformed mesh hides none of it.
class MeshOutline
{
public:
  void AddTo(CLI::App& command);
  [[nodiscard]] bool IsAsked() const { return Kind != Of::Nothing; }
  /// Converts lengths in points, as PixelLength::Resolve.
  void ResolveLengths(const std::optional<double>& dpi) { Width.Resolve(dpi); }
  /// The buffers of centres that Draw reads.
  [[nodiscard]] Buffer Needs() const;
  /// Points that a camera must show for a complete outline.
  [[nodiscard]] std::vector<Vec3> Points(const Shot& shot) const;
  /// Draws on the image of a painted frame. Throws Error where the mesh has no boundary.
  void Draw(const Shot& shot, Frame& frame) const;
  /// The same lines in the picture's pixels. Throws as Draw.
  [[nodiscard]] std::vector<std::vector<CanvasPoint>> Paths(
    const Shot& shot, const Frame& frame) const;
  [[nodiscard]] double LineWidth() const { return Width.Pixels(); }
  [[nodiscard]] Rgba LineColor() const;

private:
  enum class Of
  {
    Nothing,
    Box,
    Boundary,
    Undeformed
  };
  Of Kind = Of::Nothing;
  PixelLength Width;
  std::vector<double> Color{ 0.0, 0.0, 0.0 };
};
} // namespace pixelexact
