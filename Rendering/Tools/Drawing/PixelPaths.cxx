// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PixelPaths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
/// A corner of pixels.
using Corner = std::array<int, 2>;
using Path = std::vector<CanvasPoint>;

std::array<Corner, 2> EndsOf(const PixelStep& step)
{
  return step.across ? std::array{ Corner{ step.i + 1, step.j }, Corner{ step.i + 1, step.j + 1 } }
                     : std::array{ Corner{ step.i, step.j + 1 }, Corner{ step.i + 1, step.j + 1 } };
}

double DistanceTo(const CanvasPoint& p, const CanvasPoint& a, const CanvasPoint& b)
{
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double square = dx * dx + dy * dy;
  const double part =
    square > 0.0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - part * dx, p[1] - a[1] - part * dy);
}

/// Simplifies a path by Douglas and Peucker (1973): keeps the farthest point where its distance
/// exceeds the tolerance.
Path Simplified(const Path& path, double tolerance)
{
  std::vector<bool> stays(path.size(), false);
  stays.front() = stays.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, path.size() - 1 } };
  while (!open.empty())
  {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t farthest = first;
    for (std::size_t k = first + 1; k < last; ++k)
    {
      if (const double away = DistanceTo(path[k], path[first], path[last]); away > most)
      {
        most = away;
        farthest = k;
      }
    }
    if (farthest != first)
    {
      stays[farthest] = true;
      open.emplace_back(first, farthest);
      open.emplace_back(farthest, last);
    }
  }
  Path simple;
  for (std::size_t k = 0; k < path.size(); ++k)
  {
    if (stays[k])
    {
      simple.push_back(path[k]);
    }
  }
  return simple;
}

class Chains
{
public:
  explicit Chains(const std::vector<PixelStep>& steps)
    : Steps(steps)
    , Done(steps.size(), false)
  {
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
      for (const Corner& corner : EndsOf(steps[k]))
      {
        At[corner].push_back(k);
      }
    }
  }

  std::vector<Path> All()
  {
    std::vector<Path> paths;
    for (const auto& [corner, steps] : At)
    {
      for (const std::size_t step : steps.size() != 2 ? steps : std::vector<std::size_t>())
      {
        if (!Done[step])
        {
          paths.push_back(Follow(corner, step));
        }
      }
    }
    for (std::size_t step = 0; step < Steps.size(); ++step)
    {
      if (!Done[step])
      {
        Path loop = Follow(EndsOf(Steps[step])[0], step);
        loop.push_back(loop.front());
        paths.push_back(std::move(loop));
      }
    }
    return paths;
  }

private:
  /// Adds the mean of the steps at a corner where more than two meet.
  void AddJunction(const Corner& corner, Path& path) const
  {
    const std::vector<std::size_t>& steps = At.at(corner);
    if (steps.size() < 3)
    {
      return;
    }
    CanvasPoint middle{};
    for (const std::size_t step : steps)
    {
      middle[0] += Steps[step].at[0] / static_cast<double>(steps.size());
      middle[1] += Steps[step].at[1] / static_cast<double>(steps.size());
    }
    path.push_back(middle);
  }

  Path Follow(Corner from, std::size_t step)
  {
    Path path;
    AddJunction(from, path);
    while (!Done[step])
    {
      Done[step] = true;
      path.push_back(Steps[step].at);
      const auto ends = EndsOf(Steps[step]);
      from = ends[0] == from ? ends[1] : ends[0];
      const std::vector<std::size_t>& next = At.at(from);
      if (next.size() != 2)
      {
        AddJunction(from, path);
        break;
      }
      step = next[0] == step ? next[1] : next[0];
    }
    return path;
  }

  const std::vector<PixelStep>& Steps;
  std::vector<bool> Done;
  std::map<Corner, std::vector<std::size_t>> At;
};
} // namespace

std::vector<std::vector<CanvasPoint>> PathsOf(const std::vector<PixelStep>& steps, double tolerance)
{
  std::vector<Path> paths = Chains(steps).All();
  for (Path& path : paths)
  {
    path = Simplified(path, tolerance);
  }
  return paths;
}
} // namespace pixelexact
