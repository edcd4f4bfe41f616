// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/IntervalParts.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
class TileVisit;

/// Levels of subdivision that JudgeByIntervals takes, at most: an edge in 256 parts.
inline constexpr int kMostSubdivisions = 8;

/// What became of pixels, for reports and tests.
struct IntervalCounters
{
  std::int64_t in = 0;
  std::int64_t out = 0; ///< of pixels that show the mesh at a sample of their edge
  std::int64_t undecided = 0;
  /// Of the undecided, those with a part of which nothing is proven (PartVerdict::Unproven); of the
  /// others the intervals are too wide.
  std::int64_t unproven = 0;
  /// By level, 0 the corners: pixels that became In there, and that were undecided after it; these
  /// are the algorithm's results with fewer subdivisions.
  std::array<std::int64_t, kMostSubdivisions + 1> inAt{};
  std::array<std::int64_t, kMostSubdivisions + 1> undecidedAfter{};
  std::array<std::int64_t, kMostSubdivisions + 1> unprovenAfter{};
  std::int64_t samples = 0; ///< on edges, beside the corners
  std::int64_t parts = 0;   ///< of edges, that were judged

  void Add(const IntervalCounters& other);
};

/// The contouring algorithm as published (paper, section 5.3), the reference for the project's own.
///
/// 1. A pixel is In if two of its corners bracket an iso-value of a layer that both show.
/// 2. On the edges of the others, intervals of the field (IntervalParts): where no iso-value lies
///    in those of all four, the pixel is Out.
/// 3. `subdivisions` times: parts of edges that are still possible are halved, with a sample at the
///    middle; a pixel with samples that bracket a value is In, one whose parts are all without a
///    value Out.
/// What is left is Undecided.
///
/// Out is proven. In means, as in the paper's equation 12, that two points of the edge bracket the
/// value: it occurs between them if the field is continuous on the way, else it jumps there.
///
/// `values`: of each of the scene's layers its iso-values, in ascending order; layers beyond the
/// list have none. `verdicts`: of the tile's pixels, row by row, a ContourVerdict each. The
/// corners must have kEdgeSampleBuffers. What a pixel gets does not depend on tiles. Throws Error
/// for subdivisions beyond 0 to kMostSubdivisions, and for more lists of values than layers.
void JudgeByIntervals(TileVisit& tile, std::span<const std::vector<double>> values,
  int subdivisions, std::span<std::uint8_t> verdicts, IntervalCounters& counters);
} // namespace pixelexact
