// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/Segment.h"
#include "Core/Math/Vec.h"

#include <memory>
#include <span>
#include <vector>

namespace pixelexact
{
/// Embree's bounding volume hierarchy over the boxes of elements, or of a surface's pieces. Its
/// float coordinates are relative to all of them (centre subtracted, scaled by a power of two),
/// rounded outwards; since rounding is monotone, a box that holds a double point also holds it
/// after that.
class Bvh
{
public:
  /// Throws Error when Embree cannot make the hierarchy.
  Bvh(std::span<const Box3> boxes, const Box3& bounds);
  ~Bvh();
  Bvh(const Bvh&) = delete;
  Bvh& operator=(const Bvh&) = delete;

  /// Numbers of all boxes that meet `region` (world coordinates), ascending.
  void Query(const Box3& region, std::vector<int>& out) const;

  /// Numbers of all boxes that a segment of a ray meets, as ClipRay cuts it off by the bounds, and
  /// of some others near it. Ascending.
  void QueryAlong(const Segment& segment, std::vector<int>& out) const;

  [[nodiscard]] std::size_t MemoryUsage() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
} // namespace pixelexact
