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
  /// `all`: keep more than one root inside per point.
  explicit FoundRoots(bool all)
    : All(all)
  {
  }

  /// Adds a root, unless it is inside and does not hold, or is already known.
  void Add(std::size_t point, const InverseRoot& root, const RootCheck& check);
  /// Adds a root without checks.
  void Keep(std::size_t point, const InverseRoot& root, const RootCheck& check);
  /// Whether a root of the point is known so close to xi that both are one within `tolerances` of
  /// the faces'.
  [[nodiscard]] bool IsKnown(std::size_t point, const Vec3& xi, bool inside, const RootCheck& check,
    double tolerances) const;
  /// Whether every xi of the box is so close to a known root of the point that no other root can be
  /// separated from it.
  [[nodiscard]] bool IsAll(const Box3& box, std::size_t point) const;

  [[nodiscard]] const std::vector<InverseRoot>& Of(std::size_t point) const { return Roots[point]; }
  /// [n]: the n-th root of each point.
  [[nodiscard]] std::span<const GroupRoots> Lanes() const { return InLanes; }
  /// Points that need no further roots.
  [[nodiscard]] Bits Done() const { return WithEnough; }

private:
  bool All;
  std::array<std::vector<InverseRoot>, kGroupPoints> Roots;
  std::vector<GroupRoots> InLanes;
  Bits WithEnough = 0;
};
} // namespace pixelexact
