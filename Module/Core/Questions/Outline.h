// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <cstddef>
#include <span>

namespace pixelexact
{
/// A segment, or a flat convex polygon of up to four corners, clipped by half-spaces.
class Outline
{
public:
  static constexpr std::size_t kMaxCorners = 4;

  Outline() = default;
  Outline(const Vec3& from, const Vec3& to)
    : Points{ from, to }
    , Count(2)
  {
  }
  /// Two to four corners, in order.
  explicit Outline(std::span<const Vec3> corners)
    : Count(corners.size())
  {
    for (std::size_t k = 0; k < Count; ++k)
    {
      Points[k] = corners[k];
    }
  }

  [[nodiscard]] std::span<const Vec3> Corners() const { return { Points.data(), Count }; }
  [[nodiscard]] bool IsEmpty() const { return Count == 0; }
  [[nodiscard]] Vec3 Middle() const;

  /// Clips to the points where depth(x), which is affine, is not negative, and some points next to
  /// these, for rounding. At most kMaxCuts times.
  template <class Depth>
  void Keep(const Depth& depth);
  static constexpr std::size_t kMaxCuts = 7;

private:
  std::array<Vec3, kMaxCorners + kMaxCuts> Points{};
  std::size_t Count = 0;
};

inline Vec3 Outline::Middle() const
{
  Vec3 sum(0.0);
  for (const Vec3& point : Corners())
  {
    sum += point;
  }
  return sum / static_cast<double>(Count);
}

template <class Depth>
void Outline::Keep(const Depth& depth)
{
  /// Cuts are moved outwards by this fraction of a side.
  constexpr double kBeside = 1e-12;
  std::array<double, kMaxCorners + kMaxCuts> depths;
  bool any = false;
  bool all = true;
  for (std::size_t k = 0; k < Count; ++k)
  {
    depths[k] = depth(Points[k]);
    // The comparison is written so that a NaN is kept.
    any = any || !(depths[k] < 0.0);
    all = all && !(depths[k] < 0.0);
  }
  if (all || !any)
  {
    Count = all ? Count : 0;
    return;
  }
  const Outline before = *this;
  const bool isSegment = before.Count == 2;
  Count = 0;
  for (std::size_t k = 0; k < before.Count; ++k)
  {
    const std::size_t next = k + 1 < before.Count ? k + 1 : 0;
    if (!(depths[k] < 0.0))
    {
      Points[Count++] = before.Points[k];
    }
    if ((depths[k] < 0.0) != (depths[next] < 0.0) && !(isSegment && next == 0))
    {
      const double outwards = depths[k] < 0.0 ? -kBeside : kBeside;
      const double at = depths[k] / (depths[k] - depths[next]) + outwards;
      Points[Count++] = before.Points[k] + at * (before.Points[next] - before.Points[k]);
    }
  }
}
} // namespace pixelexact
