// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>

namespace pixelexact
{
/// A place on a reference face: parts, 0 to 1, of its two edges from corner 0. In triangles their
/// sum is at most 1.
using FacePoint = std::array<double, 2>;

/// A face of a shape in xi, where it is a parallelogram or a triangle.
struct ReferenceFace
{
  std::array<Vec3, 4> corner{}; ///< in turn, counterclockwise as seen from outside
  int corners = 4;

  [[nodiscard]] Vec3 First() const { return corner[1] - corner[0]; }
  [[nodiscard]] Vec3 Second() const
  {
    return corner[static_cast<std::size_t>(corners) - 1] - corner[0];
  }
  [[nodiscard]] Vec3 At(const FacePoint& point) const
  {
    return corner[0] + point[0] * First() + point[1] * Second();
  }
  /// The point of the face next to this one.
  [[nodiscard]] FacePoint Nearest(const FacePoint& point) const;
};

/// Face number `face` of FacesOf(shape).
const ReferenceFace& ReferenceFaceOf(Shape shape, int face);
} // namespace pixelexact
