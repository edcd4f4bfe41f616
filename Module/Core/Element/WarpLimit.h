// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/MeshRanges.h"
#include "Core/Element/Warp.h"
#include "Core/Math/Rounding.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pixelexact
{
struct WarpEffort
{
  /// The limits are to differ by at most this part of the upper one; 0 < tolerance.
  double tolerance = 1e-6;
  int boxes = 20000; ///< work budget: parts of elements that are bounded, in all
};

/// Up to which scale s the map x + s u of a mesh is proven not to fold.
struct WarpLimit
{
  /// det J of all elements that are not in `leftOut` is proven positive for every scale from 0 to
  /// less than this; infinite where the displacement is constant.
  double positive = 0.0;
  /// det J is proven not to be positive at this scale, at `xi` of `element`; infinite where no such
  /// scale was found.
  double inverted = kInfinity;
  int element = -1;
  Vec3 xi{ std::numeric_limits<double>::quiet_NaN() };
  /// Elements of which no limit is given: det J of the mesh as it is, is not proven positive, or
  /// has no bound (pyramids whose derivatives are not bounded at the apex).
  std::vector<int> leftOut;
  std::int64_t boxes = 0; ///< bounded in all
  bool met = false;       ///< the tolerance
};

/// The limits of the functions that the stored coefficients define, for scales of 0 or more; negate
/// the terms' directions for others. det J
/// is a cubic in s whose coefficients are polynomials in xi; their Bernstein coefficients over a
/// box are cubics in s, and det J is positive where all of these are. Boxes with the smallest
/// scales are subdivided. Parallel; the result is independent of the number of threads. Throws
/// Unsupported for orders above 21, InvalidData as JoinModes.
[[nodiscard]] WarpLimit FindWarpLimit(const Mesh& mesh, std::span<const WarpTerm> displacement,
  const WarpEffort& effort = {}, const RangeProgress& progress = {});
} // namespace pixelexact
