// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <span>

namespace pixelexact
{
/// The plane of a shape's face in xi: its distance along the xi axes, of which Margin is the
/// smallest, is gradient xi + constant.
struct FacePlane
{
  Vec3 gradient{ 0.0 };
  double constant = 0.0;

  /// >= 0 inside of the shape and on the face; at most 2 inside.
  [[nodiscard]] double Distance(const Vec3& xi) const
  {
    return gradient.x * xi.x + gradient.y * xi.y + gradient.z * xi.z + constant;
  }
};

/// The planes of all faces of a shape, in the order of FacesOf.
std::span<const FacePlane> FacePlanesOf(Shape shape);
} // namespace pixelexact
