// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/IntervalParts.h"
#include "Trace/TraceTile.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// A tile's pixels with their edges: first those that go across, rows from below, then those that
/// go up.
class IntervalLattice
{
public:
  explicit IntervalLattice(const TileArea& area)
    : Width(area.Width())
    , Height(area.Height())
  {
  }

  [[nodiscard]] int Pixels() const { return Width * Height; }
  [[nodiscard]] int Edges() const { return AcrossEdges() + (Width + 1) * Height; }
  /// The corners between which an edge goes.
  [[nodiscard]] std::array<int, 2> CornersOf(int edge) const
  {
    const auto [x, y, up] = Place(edge);
    const int first = y * (Width + 1) + x;
    return { first, first + (up ? Width + 1 : 1) };
  }
  /// The pixels of the tile on its two sides; -1 beyond the tile.
  [[nodiscard]] std::array<int, 2> PixelsOf(int edge) const
  {
    const auto [x, y, up] = Place(edge);
    return { PixelAt(up ? x - 1 : x, up ? y : y - 1), PixelAt(x, y) };
  }
  [[nodiscard]] std::array<int, 4> CornersOfPixel(int pixel) const
  {
    const int first = pixel / Width * (Width + 1) + pixel % Width;
    return { first, first + 1, first + Width + 1, first + Width + 2 };
  }

private:
  struct EdgePlace
  {
    int x;
    int y;
    bool up;
  };
  [[nodiscard]] int AcrossEdges() const { return Width * (Height + 1); }
  [[nodiscard]] EdgePlace Place(int edge) const
  {
    const int up = edge - AcrossEdges();
    return up < 0 ? EdgePlace{ edge % Width, edge / Width, false }
                  : EdgePlace{ up % (Width + 1), up / (Width + 1), true };
  }
  [[nodiscard]] int PixelAt(int x, int y) const
  {
    return x >= 0 && x < Width && y >= 0 && y < Height ? y * Width + x : -1;
  }

  int Width;
  int Height;
};

class TileVisit;

/// Levels of subdivision that ClassifyByIntervals takes, at most: an edge in 256 parts.
inline constexpr int kMaxSubdivisions = 8;

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
  std::array<std::int64_t, kMaxSubdivisions + 1> inAt{};
  std::array<std::int64_t, kMaxSubdivisions + 1> undecidedAfter{};
  std::array<std::int64_t, kMaxSubdivisions + 1> unprovenAfter{};
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
/// for subdivisions beyond 0 to kMaxSubdivisions, and for more lists of values than layers.
void ClassifyByIntervals(TileVisit& tile, std::span<const std::vector<double>> values,
  int subdivisions, std::span<std::uint8_t> verdicts, IntervalCounters& counters);
} // namespace pixelexact
