// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Rays.h"

#include <array>
#include <cstddef>
#include <limits>

namespace pixelexact
{
/// The least and the most of some numbers; of none, nothing.
struct NumberRange
{
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

/// What a bundle knows of its rays (RayBundle), ray by ray: arrays with room for whole packs.
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

/// What the rays have in common: of those that are of interest.
struct BundleRanges
{
  std::array<NumberRange, 2> place;
  std::array<NumberRange, 2> slope;
  NumberRange depth;
  double mostSlack = 0.0;
  double mostFar = -std::numeric_limits<double>::infinity();
};

/// Where the rays of a bundle run, and what for.
struct BundleFrame
{
  std::array<int, 3> axes;
  double z0;
  double sign;
  double around; ///< the largest coordinate that is met
};

/// Boxes that are asked about together, coordinate by coordinate.
struct EightBoxes
{
  static constexpr std::size_t kMax = 8;
  std::array<std::array<double, kMax>, 3> lower{};
  std::array<std::array<double, kMax>, 3> upper{};
  int count = 0; ///< the others mean nothing

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
  /// Of `count` rays from number `first` on, the ways that those run that are there: bit 2 a of
  /// axis a upwards, bit 2 a + 1 downwards. A ray runs along the first axis of those that its
  /// direction is longest along.
  unsigned (*ways)(const RayLanes& rays, int first, int count);
  /// Of `count` rays from number `first` on. Those that do not run along the frame's last axis, in
  /// the direction of its sign, are of no interest.
  void (*describe)(const RayLanes& rays, int first, int count, const BundleFrame& frame,
    const BundleColumns& to, BundleRanges& ranges);
  /// Which of the boxes rays of a bundle may meet, a bit each, and how deep they begin, of each
  /// (EightBoxes::kMax): RayBundle::MayMeet and DepthOf of one.
  unsigned (*meetBoxes)(
    const BundleRanges& ranges, const BundleFrame& frame, const EightBoxes& boxes, double* depth);
};

const BundleKernels& GetBundleKernels();
} // namespace pixelexact
