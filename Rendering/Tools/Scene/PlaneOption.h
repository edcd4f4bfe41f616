// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Plane.h"

#include <string>

namespace pixelexact
{
/// A plane of --plane: given by numbers, or across an axis at a place in the mesh's box.
class PlaneChoice
{
public:
  static constexpr const char* kForm = "ox,oy,oz,nx,ny,nz|AXIS[=AT|=PERCENT%]";

  /// Parses six numbers, or an axis x, y or z that is normal to the plane: through the middle of
  /// the mesh's box, at a coordinate ("z=0.2"), or at a part of the box from its lower side
  /// ("z=10%"). Throws UsageError for other texts and for numbers that describe no plane.
  static PlaneChoice Read(const std::string& text);
  /// The plane through the middle, across the shortest side. If sides are equal to a percent, z
  /// precedes y, and y precedes x.
  static PlaneChoice ThroughTheMiddle();

  [[nodiscard]] Plane Make(const Box3& box) const;
  /// The plane as six numbers, with the fewest digits that reproduce it.
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
