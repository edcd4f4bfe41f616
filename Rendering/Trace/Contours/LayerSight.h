// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeJudge.h"
#include "Trace/TileVisit.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// What the rays of a tile see of one layer's surface.
class LayerSight
{
public:
  LayerSight(TileVisit& tile, int layer);

  [[nodiscard]] const Surface& GetSurface() const { return TheSurface; }
  [[nodiscard]] bool Shows(const EdgeEnd& end) const { return end.layer == Layer; }
  [[nodiscard]] bool ShowsAt(const SampleBuffers& samples, std::size_t i) const
  {
    return samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
      samples.layer[i] == Layer;
  }
  /// Of a sample with kEdgeSampleBuffers and, where the surface has pieces, Buffer::Piece.
  [[nodiscard]] EdgeEnd EndOf(
    const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const;
  [[nodiscard]] std::vector<EdgeEnd> Trace(std::span<const ImagePosition> positions);

  [[nodiscard]] SurfaceEdge EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Whether another layer is seen instead.
  [[nodiscard]] bool Hides(const EdgeEnd& end) const { return end.layer >= 0 && !Shows(end); }
  /// How far off the triangle between three ends it is.
  [[nodiscard]] double SagittaOver(const std::array<const EdgeEnd*, 3>& ends) const;
  /// Whether two ends that show it are about as far apart as their rays, so that it may well go on
  /// between them.
  [[nodiscard]] bool AreNear(const EdgeEnd& a, const EdgeEnd& b) const;

private:
  [[nodiscard]] Ray RayOf(const EdgeEnd& end) const;

  TileVisit& Tile;
  int Layer;
  const Surface& TheSurface;
};
} // namespace pixelexact
