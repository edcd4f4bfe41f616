// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeClassifier.h"
#include "Trace/Frame.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/TileVisit.h"
#include "Trace/TraceTile.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// The sample at a point of a pixel's edge.
struct EdgeSample
{
  ImagePosition at{};
  PixelVerdict verdict = PixelVerdict::Nothing;
  std::uint8_t layer = kNoLayer;
  int element = -1;
  double value = 0.0;
  Vec3 xi{ 0.0 };
  Vec3 position{ 0.0 };
};

/// The buffers that a sample is made of.
inline constexpr Buffer kEdgeSampleBuffers =
  Buffer::Value | Buffer::Verdict | Buffer::Layer | Buffer::Element | Buffer::Xi | Buffer::Position;
inline EdgeSample SampleFrom(const SampleBuffers& samples, std::size_t i, const ImagePosition& at)
{
  return { at, static_cast<PixelVerdict>(samples.verdict[i]), samples.layer[i],
    static_cast<int>(samples.element[i]), samples.value.empty() ? std::nan("") : samples.value[i],
    samples.xi[i], samples.position[i] };
}

/// What the rays of a tile see of one layer's surface.
class LayerSight
{
public:
  LayerSight(TileVisit& tile, int layer);

  [[nodiscard]] const Surface& GetSurface() const { return surface_; }
  /// The surface, if it is a plane; else null.
  [[nodiscard]] const Plane* AsPlane() const { return plane_; }
  [[nodiscard]] bool Shows(const EdgeEnd& end) const { return end.layer == Layer; }
  [[nodiscard]] bool ShowsAt(const SampleBuffers& samples, std::size_t i) const
  {
    return samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
      samples.layer[i] == Layer;
  }
  /// Of a sample with kEdgeSampleBuffers and, where the surface has pieces, Buffer::Piece.
  [[nodiscard]] EdgeEnd EndOf(
    const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const;
  /// Where its ray meets a plane: sets x, meets and isAhead.
  void MeetPlane(EdgeEnd& end) const;
  [[nodiscard]] std::vector<EdgeEnd> Trace(std::span<const ImagePosition> positions);

  /// Between their rays, as far as the mesh goes.
  [[nodiscard]] EdgeBeam BeamBetween(const EdgeEnd& a, const EdgeEnd& b) const
  {
    return { RayOf(a), RayOf(b), Tile.GetScene().locator->Index().Bounds() };
  }
  [[nodiscard]] SurfaceEdge EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Whether no ray between those of some ends, in order around, meets a plane in the mesh: it is
  /// behind the eye, or farther off than the mesh, as towards the horizon. Of other surfaces false.
  [[nodiscard]] bool IsPlaneBeyond(std::span<const EdgeEnd> ends) const;
  /// Whether another layer is seen instead.
  [[nodiscard]] bool Hides(const EdgeEnd& end) const { return end.layer >= 0 && !Shows(end); }
  /// How far off the triangle between three ends it is.
  [[nodiscard]] double SagittaOver(const std::array<const EdgeEnd*, 3>& ends) const;
  /// Whether two ends that show it are about as far apart as their rays, so that it may well go on
  /// between them.
  [[nodiscard]] bool AreNear(const EdgeEnd& a, const EdgeEnd& b) const;

private:
  [[nodiscard]] Ray RayOf(const EdgeEnd& end) const;
  /// Along the direction of view, in units of the rays' own; of cameras whose rays meet in the eye.
  [[nodiscard]] double DepthOf(const Vec3& x) const;

  TileVisit& Tile;
  int Layer;
  const Surface& surface_;
  const Plane* plane_; ///< the surface, if it is one
  bool IsParallel;
  double MeshDepth = 0.0; ///< of the mesh's farthest point, or more
};
} // namespace pixelexact
