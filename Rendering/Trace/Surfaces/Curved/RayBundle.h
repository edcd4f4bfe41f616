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
/// Neighbouring rays seen together: lines over one coordinate of space, along which all of them
/// run. Boxes are tested against all at once, by what their places and slopes have in common.
///
/// Ray i is x_a(z) = place[a][i] + slope[a][i] (z - z0), z its coordinate x[axes[2]] and a one of
/// the other two. Its depth is the distance from z0 along that coordinate, counted in the direction
/// of the rays. All of it depends on the ray alone.
class RayBundle
{
public:
  static constexpr int kMax = 128;
  static constexpr std::size_t kPadded = kMax + kLanePadding;
  using Numbers = std::array<double, kPadded>;

  /// Of `count` rays from number `first` those that run one way (BundleKernels::ways, the bit's
  /// number), about a box: z0 lies in its middle. No box is met by the others.
  void Begin(const RayLanes& rays, int first, int count, int way, const Box3& about);

  [[nodiscard]] int Count() const { return Size; }
  [[nodiscard]] int First() const { return Offset; }

  /// Whether a ray of them may meet the box; no ray that does (PieceKernels::meetBox) is passed
  /// over.
  [[nodiscard]] bool MayMeet(const Box3& box) const
  {
    // The same sums as for a ray alone, of numbers that are no larger, or no smaller: rounding is
    // monotone, so that no box is left out that one of the rays would not leave out. What is no
    // number leaves out nothing.
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
  /// No point of the box is nearer.
  [[nodiscard]] double DepthOf(const Box3& box) const
  {
    return (sign > 0.0 ? box.lower[axes[2]] - z0 : z0 - box.upper[axes[2]]) - Ranges.mostSlack;
  }
  /// The same of one ray, by its own rounding: whatever rays are beside it.
  [[nodiscard]] double DepthOf(const Box3& box, int i) const
  {
    return (sign > 0.0 ? box.lower[axes[2]] - z0 : z0 - box.upper[axes[2]]) -
      slack[static_cast<std::size_t>(i)];
  }

  /// The same of up to eight boxes: a bit each, and their depths.
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
  /// The t of a depth.
  [[nodiscard]] double TimeOf(int i, double depth) const
  {
    const auto at = static_cast<std::size_t>(i);
    return (sign * depth - Origin[at]) / Direction[at];
  }
  /// The ray is of no interest beyond a depth.
  void EndAt(int i, double depth)
  {
    const auto at = static_cast<std::size_t>(i);
    far[at] = std::min(far[at], depth + slack[at]);
  }
  /// How far off places may be, by rounding, of the rays of which least is known.
  [[nodiscard]] double MostSlack() const { return Ranges.mostSlack; }
  /// Beyond it no ray is of interest. What has ended since FindFarthest does not count.
  [[nodiscard]] double Farthest() const { return Ranges.mostFar; }
  void FindFarthest();

  std::array<int, 3> axes{};
  double z0 = 0.0;
  double sign = 1.0; ///< of the directions along axes[2]
  std::array<Numbers, 2> place{};
  std::array<Numbers, 2> slope{};
  Numbers slack{}; ///< how far off places may be, by rounding
  Numbers near{};  ///< of interest from this depth, rounding included
  Numbers far{};   ///< to this one

private:
  int Size = 0;
  int Offset = 0;
  BundleRanges Ranges;
  Numbers Origin{};    ///< along axes[2], from z0
  Numbers Direction{}; ///< along axes[2]
};

/// Some of a bundle's rays: a bit each.
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
