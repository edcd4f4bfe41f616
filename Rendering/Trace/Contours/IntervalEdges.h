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
/// Numbers a tile's pixels, corners and edges. Horizontal edges come first, in rows from below,
/// then vertical ones.
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
  /// The corners at the ends of an edge.
  [[nodiscard]] std::array<int, 2> CornersOf(int edge) const
  {
    const auto [x, y, up] = Place(edge);
    const int first = y * (Width + 1) + x;
    return { first, first + (up ? Width + 1 : 1) };
  }
  /// The pixels on the two sides of an edge; -1: outside the tile.
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

/// Largest count of subdivisions in ClassifyByIntervals: an edge has up to 256 parts.
inline constexpr int kMaxSubdivisions = 8;

/// Counts of pixels by verdict, for reports and tests.
struct IntervalCounters
{
  std::int64_t in = 0;
  std::int64_t out = 0; ///< only pixels that show the mesh at a sample of their edge
  std::int64_t undecided = 0;
  /// Undecided pixels with a part that has no interval (PartVerdict::Unproven). The intervals of
  /// the other undecided pixels are too wide.
  std::int64_t unproven = 0;
  /// By level, where level 0 is the corners: pixels that became In at the level, and pixels that
  /// stayed undecided after it. They are the algorithm's results with fewer subdivisions.
  std::array<std::int64_t, kMaxSubdivisions + 1> inAt{};
  std::array<std::int64_t, kMaxSubdivisions + 1> undecidedAfter{};
  std::array<std::int64_t, kMaxSubdivisions + 1> unprovenAfter{};
  std::int64_t samples = 0; ///< on edges, without corners
  std::int64_t parts = 0;   ///< of edges, classified

  void Add(const IntervalCounters& other);
};

/// The contouring algorithm as published (paper, section 5.3), the reference for the project's own.
///
/// 1. A pixel is In if two of its corners bracket an iso-value of a layer that both show.
/// 2. The edges of the other pixels get intervals of the field (IntervalParts). A pixel is Out if
///    none of its edges' intervals contains an iso-value.
/// 3. This step is repeated `subdivisions` times. Open parts of edges are subdivided at a sample in
///    their middle. A pixel with samples that bracket an iso-value is In. A pixel with no open part
///    is Out.
/// The remaining pixels are Undecided.
///
/// Out is proven. In means, as in the paper's equation 12, that two points of the edge bracket the
/// value: it occurs between them if the field is continuous on the way, else it jumps there.
///
/// `values`: the iso-values of each of the scene's layers, in ascending order; layers without a
/// list have none. `verdicts`: a ContourVerdict for each of the tile's pixels, row by row. The
/// corners must have kEdgeSampleBuffers. A pixel's verdict does not depend on tiles. Throws Error
/// if `subdivisions` is outside 0 to kMaxSubdivisions, or if there are more lists of values than
/// layers.
void ClassifyByIntervals(TileVisit& tile, std::span<const std::vector<double>> values,
  int subdivisions, std::span<std::uint8_t> verdicts, IntervalCounters& counters);
} // namespace pixelexact
