// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Rays.h"

#include <array>
#include <cstddef>
#include <limits>

namespace pixelexact
{
/// The range of some numbers; empty by default.
struct NumberRange
{
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

/// The arrays of a bundle (RayBundle), by ray, padded to whole packs.
struct BundleColumns
{
  std::array<double*, 2> place;
  std::array<double*, 2> slope;
  double* slack;
  double* near;
  double* far;
  double* origin;
  double* direction;
};

/// Ranges over the rays that run along the bundle's way.
struct BundleRanges
{
  std::array<NumberRange, 2> place;
  std::array<NumberRange, 2> slope;
  NumberRange depth;
  double mostSlack = 0.0;
  double mostFar = -std::numeric_limits<double>::infinity();
};

/// Axes and origin of a bundle's coordinates.
struct BundleFrame
{
  std::array<int, 3> axes;
  double z0;
  double sign;
  double around; ///< largest magnitude of a coordinate of met boxes
};

/// Boxes that are tested together, as a structure of arrays.
struct EightBoxes
{
  static constexpr std::size_t kMax = 8;
  std::array<std::array<double, kMax>, 3> lower{};
  std::array<std::array<double, kMax>, 3> upper{};
  int count = 0; ///< the other entries are undefined

  void Set(std::size_t k, const Box3& box)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      lower[d][k] = box.lower[static_cast<int>(d)];
      upper[d][k] = box.upper[static_cast<int>(d)];
    }
  }
};

/// Kernels dispatched at run time to the instruction set. All of them give the same bits.
struct BundleKernels
{
  /// The ways along which `count` rays from number `first` on run: bit 2 a for axis a upwards, bit
  /// 2 a + 1 downwards. A ray runs along the first of the axes on which its direction is longest.
  unsigned (*ways)(const RayLanes& rays, int first, int count);
  /// Describes `count` rays from number `first` on. Rays that do not run along the frame's last
  /// axis, in the direction of its sign, get an empty interval of depths.
  void (*describe)(const RayLanes& rays, int first, int count, const BundleFrame& frame,
    const BundleColumns& to, BundleRanges& ranges);
  /// The boxes that rays of a bundle may meet, a bit each, and the depth at which each begins
  /// (EightBoxes::kMax numbers), as RayBundle::MayMeet and DepthOf for one box.
  unsigned (*meetBoxes)(
    const BundleRanges& ranges, const BundleFrame& frame, const EightBoxes& boxes, double* depth);
};

const BundleKernels& GetBundleKernels();
} // namespace pixelexact
