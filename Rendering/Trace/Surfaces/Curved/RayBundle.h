// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Rays.h"
#include "Trace/Surfaces/Curved/BundleKernels.h"

#include "Core/Math/Vec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace pixelexact
{
/// Neighbouring rays, processed together as lines over one coordinate of space, along which all of
/// them run. Boxes are tested against all rays at once, by ranges of their places and slopes.
///
/// Ray i is x_a(z) = place[a][i] + slope[a][i] (z - z0), where z is its coordinate x[axes[2]] and a
/// one of the other two. Its depth is the distance from z0 along that coordinate, in the direction
/// of the rays. All these numbers depend on the ray alone.
class RayBundle
{
public:
  static constexpr int kMax = 128;
  static constexpr std::size_t kPadded = kMax + kLanePadding;
  using Numbers = std::array<double, kPadded>;

  /// Takes, of `count` rays from number `first` on, those that run along `way` (bit number in
  /// BundleKernels::ways). `about`: a box whose middle gives z0. The other rays meet no box.
  void Begin(const RayLanes& rays, int first, int count, int way, const Box3& about);

  [[nodiscard]] int Count() const { return Size; }
  [[nodiscard]] int First() const { return Offset; }

  /// A ray of the bundle may meet the box. True if PieceKernels::meetBox is for any ray.
  [[nodiscard]] bool MayMeet(const Box3& box) const
  {
    // The sums are those of a single ray, with numbers that are no larger, or no smaller. Rounding
    // is monotone, so a box is excluded only if each ray alone excludes it. NaN excludes nothing.
    const double from = box.lower[axes[2]] - z0;
    const double to = box.upper[axes[2]] - z0;
    const bool isUp = sign > 0.0;
    if ((isUp ? to : -from) + Ranges.mostSlack < Ranges.depth.least ||
      (isUp ? from : -to) - Ranges.mostSlack > Ranges.depth.most)
    {
      return false;
    }
    const auto isBeside = [&](std::size_t a)
    {
      const double p = Ranges.slope[a].least * from;
      const double q = Ranges.slope[a].least * to;
      const double r = Ranges.slope[a].most * from;
      const double s = Ranges.slope[a].most * to;
      const double least = std::min(std::min(p, q), std::min(r, s));
      const double most = std::max(std::max(p, q), std::max(r, s));
      return Ranges.place[a].least + least - Ranges.mostSlack > box.upper[axes[a]] ||
        Ranges.place[a].most + most + Ranges.mostSlack < box.lower[axes[a]];
    };
    return !isBeside(0) && !isBeside(1);
  }
  /// Lower bound of the depth of the box's points.
  [[nodiscard]] double DepthOf(const Box3& box) const
  {
    return (sign > 0.0 ? box.lower[axes[2]] - z0 : z0 - box.upper[axes[2]]) - Ranges.mostSlack;
  }
  /// The same for one ray, with its own rounding, independent of other rays.
  [[nodiscard]] double DepthOf(const Box3& box, int i) const
  {
    return (sign > 0.0 ? box.lower[axes[2]] - z0 : z0 - box.upper[axes[2]]) -
      slack[static_cast<std::size_t>(i)];
  }

  /// MayMeet for up to eight boxes, a bit each, and their depths.
  [[nodiscard]] unsigned MayMeet(
    const EightBoxes& boxes, std::array<double, EightBoxes::kMax>& depth) const
  {
    return GetBundleKernels().meetBoxes(Ranges, { axes, z0, sign, 0.0 }, boxes, depth.data());
  }

  [[nodiscard]] double DepthAt(int i, double t) const
  {
    const auto at = static_cast<std::size_t>(i);
    return sign * (Origin[at] + t * Direction[at]);
  }
  [[nodiscard]] double TimeAt(int i, const Vec3& x) const
  {
    const auto at = static_cast<std::size_t>(i);
    return ((x[axes[2]] - z0) - Origin[at]) / Direction[at];
  }
  /// The t at a depth.
  [[nodiscard]] double TimeOf(int i, double depth) const
  {
    const auto at = static_cast<std::size_t>(i);
    return (sign * depth - Origin[at]) / Direction[at];
  }
  /// Ends the ray at a depth.
  void EndAt(int i, double depth)
  {
    const auto at = static_cast<std::size_t>(i);
    far[at] = std::min(far[at], depth + slack[at]);
  }
  /// Largest error of places, by rounding, over all rays.
  [[nodiscard]] double MostSlack() const { return Ranges.mostSlack; }
  /// Largest depth of all rays, as of the last FindFarthest.
  [[nodiscard]] double Farthest() const { return Ranges.mostFar; }
  void FindFarthest();

  std::array<int, 3> axes{};
  double z0 = 0.0;
  double sign = 1.0; ///< of the directions along axes[2]
  std::array<Numbers, 2> place{};
  std::array<Numbers, 2> slope{};
  Numbers slack{}; ///< largest error of places, by rounding
  Numbers near{};  ///< the ray begins at this depth, including rounding
  Numbers far{};   ///< the ray ends at this depth

private:
  int Size = 0;
  int Offset = 0;
  BundleRanges Ranges;
  Numbers Origin{};    ///< along axes[2], from z0
  Numbers Direction{}; ///< along axes[2]
};

/// A subset of a bundle's rays, a bit each.
struct RaySet
{
  static constexpr std::size_t kWords = RayBundle::kMax / 64;
  std::array<std::uint64_t, kWords> bits{};

  static RaySet First(int count)
  {
    RaySet set;
    for (int i = 0; i < count; ++i)
    {
      set.Add(i);
    }
    return set;
  }
  void Add(int ray)
  {
    bits[static_cast<std::size_t>(ray / 64)] |= std::uint64_t{ 1 }
      << static_cast<unsigned>(ray % 64);
  }
  void Add(const RaySet& others)
  {
    for (std::size_t word = 0; word < kWords; ++word)
    {
      bits[word] |= others.bits[word];
    }
  }
  [[nodiscard]] bool Has(int ray) const
  {
    return (bits[static_cast<std::size_t>(ray / 64)] >> static_cast<unsigned>(ray % 64) & 1U) != 0;
  }
  [[nodiscard]] bool IsEmpty() const { return (bits[0] | bits[1]) == 0; }
  [[nodiscard]] int Count() const { return std::popcount(bits[0]) + std::popcount(bits[1]); }
  template <class Visit>
  void ForEach(Visit&& visit) const
  {
    for (std::size_t word = 0; word < kWords; ++word)
    {
      for (std::uint64_t left = bits[word]; left != 0; left &= left - 1)
      {
        visit(static_cast<int>(64 * word) + std::countr_zero(left));
      }
    }
  }
};
} // namespace pixelexact
