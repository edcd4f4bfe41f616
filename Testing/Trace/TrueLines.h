// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SheetCheck.h"

#include <map>

// The positions of a block's inner faces on an image, in long double, from small steps over it.
namespace pixelexact::testing
{
/// 0 on the block's inner faces, by direction: Block::Map with a, b, c = 0.
inline std::array<long double, 3> InnerFaces(const LongVec3& x)
{
  return { x[0] - 0.2L * x[1] * x[2], x[1] - 0.2L * x[0], x[2] };
}

/// Points of the lines along which the layers that are nearest cross inner faces, a small step from
/// each other.
class TrueLines
{
public:
  static constexpr int kSteps = 8; ///< a pixel

  TrueLines(const TrueScene& scene, const CameraView& view, int width, int height)
    : scene_(scene)
    , View(view)
    , Width(width)
    , Height(height)
  {
    std::vector<Seen> before;
    for (int j = 0; j <= kSteps * height; ++j)
    {
      std::vector<Seen> row;
      for (int i = 0; i <= kSteps * width; ++i)
      {
        row.push_back(
          At(static_cast<long double>(i) / kSteps, static_cast<long double>(j) / kSteps));
        if (i > 0)
        {
          AddBetween(row[static_cast<std::size_t>(i) - 1], row.back());
        }
        if (j > 0)
        {
          AddBetween(before[static_cast<std::size_t>(i)], row.back());
        }
      }
      before = std::move(row);
    }
  }

  struct Nearest
  {
    double distance = 1e9;
    int direction = -1; ///< of the face
  };

  /// The line of a layer that is nearest to an image position, within 3 pixels; of one direction of
  /// faces or of any (-1).
  [[nodiscard]] Nearest To(double x, double y, int layer, int direction = -1) const
  {
    Nearest nearest;
    for (int dy = -3; dy <= 3; ++dy)
    {
      for (int dx = -3; dx <= 3; ++dx)
      {
        const auto cell = Cells.find(
          { static_cast<int>(std::floor(x)) + dx, static_cast<int>(std::floor(y)) + dy });
        for (const Point& point : cell == Cells.end() ? None : cell->second)
        {
          const double distance = std::hypot(point.x - x, point.y - y);
          if (point.layer == layer && (direction < 0 || point.direction == direction) &&
            distance < nearest.distance)
          {
            nearest = { distance, point.direction };
          }
        }
      }
    }
    return nearest;
  }

  /// Whether only one layer is visible within `within` pixels.
  [[nodiscard]] bool IsAlone(double x, double y, int layer, double within) const
  {
    for (int k = 0; k < 24; ++k)
    {
      const long double angle = std::numbers::pi_v<long double> * k / 12;
      if (At(x + within * std::cos(angle), y + within * std::sin(angle)).layer != layer)
      {
        return false;
      }
    }
    return true;
  }

  struct Seen
  {
    long double x;
    long double y;
    int layer = -1;
    std::array<long double, 3> faces{};
  };
  [[nodiscard]] Seen At(long double x, long double y) const
  {
    Seen seen{ x, y };
    const auto sheets = scene_.See(RayThrough(View, Width, Height, x, y));
    if (sheets && !sheets->empty())
    {
      seen.layer = sheets->front().layer;
      seen.faces = InnerFaces(sheets->front().position);
    }
    return seen;
  }

private:
  struct Point
  {
    double x;
    double y;
    int layer;
    int direction;
  };

  void AddBetween(const Seen& from, const Seen& to)
  {
    for (std::size_t d = 0; d < 3 && from.layer >= 0 && from.layer == to.layer; ++d)
    {
      Seen a = from;
      Seen b = to;
      if ((a.faces[d] > 0) == (b.faces[d] > 0))
      {
        continue;
      }
      for (int k = 0; k < 12 && a.layer == b.layer; ++k)
      {
        const Seen middle = At((a.x + b.x) / 2, (a.y + b.y) / 2);
        ((middle.faces[d] > 0) == (a.faces[d] > 0) ? a : b) = middle;
      }
      // Not where a layer's other side, or the background, is between.
      if (a.layer == b.layer && std::fabs(a.faces[d] - b.faces[d]) < 1e-4L)
      {
        Cells[{ static_cast<int>(std::floor(a.x)), static_cast<int>(std::floor(a.y)) }].push_back(
          { static_cast<double>(a.x), static_cast<double>(a.y), from.layer, static_cast<int>(d) });
      }
    }
  }

  const TrueScene& scene_;
  CameraView View;
  int Width;
  int Height;
  std::map<std::pair<int, int>, std::vector<Point>> Cells;
  std::vector<Point> None;
};
} // namespace pixelexact::testing
