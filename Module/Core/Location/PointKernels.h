// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/Kernels.h"

#include <cstdint>

// Tests whole packs of points before the inverse map, to find those that an element might hold.
// Dispatched at run time to the instruction set.
namespace pixelexact
{
/// Points are tested in chunks of at most this many, a bit each.
inline constexpr int kChunkPoints = 64;

/// Neighbouring points of a batch: `count` from `begin` on.
struct PointChunk
{
  int begin = 0;
  int count = 0;
  std::uint64_t open = 0; ///< a bit for each point that is still looked for
  Box3 box;               ///< of the open points, when the chunk was made
};

/// Boxes of at most 64 chunks, coordinate by coordinate, padded with empty ones.
struct BoxLanes
{
  const double* lower[3];
  const double* upper[3];
  int count;
};

/// A bit for each box.
struct NearChunks
{
  /// Boxes that may have points in the element; for all others its box or frame proves that they
  /// have none.
  std::uint64_t near = 0;
  std::uint64_t inner = 0; ///< of those near: neither box nor frame excludes a point of it
};

struct PointKernels
{
  /// Makes the chunk of points begin .. begin + count. Its open points are those within `bounds`.
  PointChunk (*chunk)(const LanePoints& points, int begin, int count, const Box3& bounds);
  /// Returns the points in `bits` that lie within the box.
  std::uint64_t (*inBox)(const LanePoints& points, int begin, std::uint64_t bits, const Box3& box);
  NearChunks (*near)(
    const ElementBounds& bounds, const InverseProblem& problem, const BoxLanes& boxes);
  /// Returns the chunk's open points to which some xi of the element's shape might map; for all
  /// others box or frame proves that none does. Stores their coordinates one after the other to
  /// `selected[d]`, which must have space for a whole pack beyond the last, and their numbers to
  /// `index`. `inner`: all points are returned without a test.
  std::uint64_t (*select)(const ElementBounds& bounds, const InverseProblem& problem,
    const LanePoints& points, const PointChunk& chunk, bool inner, double* const selected[3],
    int* index);
};

const PointKernels& GetPointKernels();

// Processes whole packs of points after the inverse map.

/// Lists which of `count` are not RootInside, in ascending order, and returns their number.
int FindOthers(const double* status, int count, int* others);

/// Moves xi, residuals and numbers of points with RootInside to the front, in order, fills the
/// result's arrays up with the last to whole packs, and returns their number. Status and margins
/// stay unchanged.
int KeepInside(const InverseResult& result, int count, int* numbers);

/// Returns those of at most 64 points y in the element's units, a bit each, for which the inverse
/// map's first guess is far enough from the faces that the element most likely holds them. This is
/// not a proof. None where the element has no guess, or a poor one.
std::uint64_t FindInnerPoints(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& y, std::uint64_t bits);

/// Returns those of `count` roots, a bit each, at which Phi is y up to `mostMiss` times the
/// uncertainty. `phi`: its three coordinates there and their nine derivatives. Stores the faces'
/// tolerances: |J^-1| times the uncertainty; zero where J is singular.
std::uint64_t CheckImages(const InverseProblem& problem, double mostMiss, int count,
  const double* const phi[12], const double* const y[3], double* const tolerance[3]);
} // namespace pixelexact
