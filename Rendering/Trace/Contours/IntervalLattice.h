// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/TraceTile.h"

#include <array>

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
} // namespace pixelexact
