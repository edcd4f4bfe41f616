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
/// The sample of a ray through a point of a pixel's edge.
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

/// The buffers that an EdgeSample is read from.
inline constexpr Buffer kEdgeSampleBuffers =
  Buffer::Value | Buffer::Verdict | Buffer::Layer | Buffer::Element | Buffer::Xi | Buffer::Position;
inline EdgeSample SampleFrom(const SampleBuffers& samples, std::size_t i, const ImagePosition& at)
{
  return { at, static_cast<PixelVerdict>(samples.verdict[i]), samples.layer[i],
    static_cast<int>(samples.element[i]), samples.value.empty() ? std::nan("") : samples.value[i],
    samples.xi[i], samples.position[i] };
}

/// Views one layer's surface by the rays of a tile.
class LayerSight
{
public:
  /// `bounds`: of the layer's field.
  LayerSight(TileVisit& tile, int layer, const LayerBounds& bounds);

  [[nodiscard]] const Surface& GetSurface() const { return surface_; }
  /// The surface as a plane; null if it is none.
  [[nodiscard]] const Plane* AsPlane() const { return plane_; }
  [[nodiscard]] bool Shows(const EdgeEnd& end) const { return end.layer == Layer; }
  [[nodiscard]] bool ShowsAt(const SampleBuffers& samples, std::size_t i) const
  {
    return samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact) &&
      samples.layer[i] == Layer;
  }
  /// A sample's value as that of the scalar that the layer's bounds are of.
  [[nodiscard]] double ValueAt(const SampleBuffers& samples, std::size_t i) const
  {
    return Bounds.ToBounded(samples.value[i]);
  }
  /// Reads a sample with kEdgeSampleBuffers and, if the surface has pieces, Buffer::Piece.
  [[nodiscard]] EdgeEnd EndOf(
    const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const;
  /// Meets the plane by the end's ray: sets x, meets and isAhead.
  void MeetPlane(EdgeEnd& end) const;
  [[nodiscard]] std::vector<EdgeEnd> Trace(std::span<const ImagePosition> positions);

  /// The beam between two ends' rays, clipped to the mesh's box.
  [[nodiscard]] EdgeBeam BeamBetween(const EdgeEnd& a, const EdgeEnd& b) const
  {
    return { RayOf(a), RayOf(b), Tile.GetScene().locator->Index().Bounds() };
  }
  [[nodiscard]] SurfaceEdge EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const;
  /// The plane is behind the eye or beyond the mesh, as towards the horizon, for all rays between
  /// those of some ends, in order around. False for other surfaces.
  [[nodiscard]] bool IsPlaneBeyond(std::span<const EdgeEnd> ends) const;
  /// The end shows another layer.
  [[nodiscard]] bool Hides(const EdgeEnd& end) const { return end.layer >= 0 && !Shows(end); }
  /// Largest distance of the surface from the triangle between three ends.
  [[nodiscard]] double SagittaOver(const std::array<const EdgeEnd*, 3>& ends) const;
  /// The distance of two ends that show the layer is comparable with that of their rays, so the
  /// surface is probably continuous between them.
  [[nodiscard]] bool AreNear(const EdgeEnd& a, const EdgeEnd& b) const;

private:
  [[nodiscard]] Ray RayOf(const EdgeEnd& end) const;
  /// Depth along the direction of view, in units of the rays' own; only for perspective cameras.
  [[nodiscard]] double DepthOf(const Vec3& x) const;

  TileVisit& Tile;
  int Layer;
  const LayerBounds& Bounds;
  const Surface& surface_;
  const Plane* plane_; ///< the surface, if it is one
  bool IsParallel;
  double MeshDepth = 0.0; ///< upper bound for the mesh's points
};
} // namespace pixelexact
