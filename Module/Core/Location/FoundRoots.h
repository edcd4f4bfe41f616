// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/PointSearch.h"
#include "Core/Location/RootCheck.h"
#include "Core/Math/Bits.h"

namespace pixelexact
{
/// The roots of a group's points that a search has found, inside or not.
class FoundRoots
{
public:
  /// `all`: inside, more than one is wanted of a point.
  explicit FoundRoots(bool all)
    : All(all)
  {
  }

  /// Takes a root, but one that is inside and does not hold, or that is known.
  void Add(std::size_t point, const InverseRoot& root, const RootCheck& check);
  /// Takes it as it is.
  void Keep(std::size_t point, const InverseRoot& root, const RootCheck& check);
  /// Whether one of the point is so near to xi that within `tolerances` of the faces' both are one.
  [[nodiscard]] bool IsKnown(std::size_t point, const Vec3& xi, bool inside, const RootCheck& check,
    double tolerances) const;
  /// Whether every xi of the box is so near to one of the point that no other could be told from
  /// it.
  [[nodiscard]] bool IsAll(const Box3& box, std::size_t point) const;

  [[nodiscard]] const std::vector<InverseRoot>& Of(std::size_t point) const { return Roots[point]; }
  /// [n]: the n-th of each point.
  [[nodiscard]] std::span<const GroupRoots> Lanes() const { return InLanes; }
  /// Points of which nothing more is wanted.
  [[nodiscard]] Bits Done() const { return WithEnough; }

private:
  bool All;
  std::array<std::vector<InverseRoot>, kGroupPoints> Roots;
  std::vector<GroupRoots> InLanes;
  Bits WithEnough = 0;
};
} // namespace pixelexact
