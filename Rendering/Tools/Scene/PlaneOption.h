// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Plane.h"

#include <string>

namespace pixelexact
{
/// A plane as --plane gives it: by numbers, or across an axis at a place that the mesh tells.
class PlaneChoice
{
public:
  static constexpr const char* kForm = "ox,oy,oz,nx,ny,nz|AXIS[=AT|=PERCENT%]";

  /// Six numbers; or x, y or z, across which the plane is: through the middle of the mesh's box, at
  /// a coordinate ("z=0.2"), or at a part of the box from its lower side ("z=10%"). Throws
  /// UsageError for what is none of these, or describes no plane.
  static PlaneChoice Read(const std::string& text);
  /// Through the middle, across the shortest side; of sides that are alike to a percent across z
  /// rather than y, and y rather than x.
  static PlaneChoice ThroughTheMiddle();

  [[nodiscard]] Plane Make(const Box3& box) const;
  /// The same plane as six numbers, so short that they give it back.
  [[nodiscard]] std::string Numbers(const Box3& box) const;

private:
  static constexpr int kNoAxis = -1;
  static constexpr int kShortest = 3;
  struct Place
  {
    Vec3 origin;
    Vec3 normal;
  };
  [[nodiscard]] Place PlaceIn(const Box3& box) const;

  Place Given{ Vec3(0.0), Vec3(0.0) };
  int Axis = kNoAxis;
  bool IsPart = true; ///< At is a part of the box's side, else a coordinate
  double At = 0.5;
};
} // namespace pixelexact
