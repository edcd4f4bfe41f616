// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

#include <array>
#include <optional>

namespace pixelexact
{
/// The position of a point in a picture.
struct ProjectedPoint
{
  std::array<double, 2> at; ///< pixels from the lower left
  double depth;             ///< along the ray there, as of Buffer::Depth
};

/// The unit vectors of a view: away from the viewer, to the right and up in the picture.
struct CameraAxes
{
  Vec3 forward;
  Vec3 right;
  Vec3 up;
};

CameraAxes AxesOf(const CameraView& view);

/// Projects points to pixels: the inverse of a Camera's rays.
class Projection
{
public:
  Projection(const CameraView& view, int width, int height);

  /// None for a point that is not in front of the viewer.
  [[nodiscard]] std::optional<ProjectedPoint> Of(const Vec3& point) const;
  /// The world's length of a pixel at a depth.
  [[nodiscard]] double PixelAt(double depth) const { return Parallel ? Slope : Slope * depth; }

  /// The point that has in `view` the position and distance that `point` has here.
  [[nodiscard]] Vec3 AsSeenFrom(const CameraView& view, const Vec3& point) const;

private:
  Vec3 Eye;
  CameraAxes Axes;
  bool Parallel;
  double Slope; ///< a pixel's side, of a perspective view at distance 1
  std::array<double, 2> Middle;
};
} // namespace pixelexact
