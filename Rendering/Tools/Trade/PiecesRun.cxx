// SPDX-License-Identifier: BSD-3-Clause
// Refines triangles of files and Bezier patches, with exact values at the corners.
#include "Base/PeakMemory.h"
#include "Bench/FrameTime.h"
#include "Trade/TrianglesRun.h"

#include "Core/Base/Counted.h"
#include "Core/Location/Sample.h"
#include "Grids/FilterWork.h"
#include "HighOrderModel.h"
#include "Trace/Surfaces/BezierPatches.h"
#include "Trace/Surfaces/Triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Parts of a patch's edge at level 0.
constexpr int kFirstParts = 16;
/// Memory per triangle and its corners during refinement.
constexpr double kBytes = 250.0;

/// A point of a Bezier curve through a line of control points, at t from 0 to 1.
Vec3 PointOf(std::vector<Vec3> line, double t)
{
  for (std::size_t last = line.size() - 1; last > 0; --last)
  {
    for (std::size_t i = 0; i < last; ++i)
    {
      line[i] = (1.0 - t) * line[i] + t * line[i + 1];
    }
  }
  return line.front();
}

Vec3 PointOf(const BezierPatch& patch, double u, double v)
{
  const auto row = static_cast<std::size_t>(patch.degree[1]) + 1;
  std::vector<Vec3> across;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(patch.degree[0]); ++i)
  {
    const auto first = patch.points.begin() + static_cast<std::ptrdiff_t>(i * row);
    across.push_back(PointOf({ first, first + static_cast<std::ptrdiff_t>(row) }, v));
  }
  return PointOf(std::move(across), u);
}

/// Points, and triangles as triples of point numbers.
struct Lattice
{
  std::vector<Vec3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  void Add(const BezierPatch& patch, int parts)
  {
    const std::size_t first = points.size();
    const auto n = static_cast<std::size_t>(parts);
    for (std::size_t i = 0; i <= n; ++i)
    {
      for (std::size_t j = 0; j <= n; ++j)
      {
        points.push_back(
          PointOf(patch, static_cast<double>(i) / parts, static_cast<double>(j) / parts));
        if (i < n && j < n)
        {
          const std::size_t at = first + i * (n + 1) + j;
          triangles.push_back({ at, at + n + 1, at + n + 2 });
          triangles.push_back({ at, at + n + 2, at + 1 });
        }
      }
    }
  }

  void Add(const Triangles::Triangle& triangle, int parts)
  {
    const auto& [a, b, c] = triangle;
    std::size_t row = points.size();
    for (int i = 0; i <= parts; ++i)
    {
      const auto count = static_cast<std::size_t>(parts - i) + 1;
      for (std::size_t j = 0; j < count; ++j)
      {
        const double t = static_cast<double>(j) / parts;
        const double s = static_cast<double>(i) / parts;
        points.push_back(a + s * (b - a) + t * (c - a));
        if (j + 1 < count)
        {
          triangles.push_back({ row + j, row + count + j, row + j + 1 });
        }
        if (j + 2 < count)
        {
          triangles.push_back({ row + count + j, row + count + j + 1, row + j + 1 });
        }
      }
      row += count;
    }
  }
};

/// Keeps the triangles whose corners are all in the mesh, with values at their corners.
LinearSurface Valued(const Lattice& lattice, const HighOrderModel& model, const Layer& layer)
{
  const Field& field = *model.FindField(layer.field->name);
  const auto components = static_cast<std::size_t>(field.values.components);
  std::vector<double> values(lattice.points.size() * components);
  std::vector<Verdict> verdicts(lattice.points.size());
  SampleTarget target;
  target.value = values;
  target.verdict = verdicts;
  Sample(model.GetLocator(), &field, lattice.points, target);
  const auto valueAt = [&](std::size_t point) {
    return ComponentOf(std::span(values).subspan(point * components, components), layer.component);
  };
  std::vector<Triangles::Triangle> shown;
  std::vector<std::array<double, 3>> corners;
  for (const auto& [a, b, c] : lattice.triangles)
  {
    if (verdicts[a] == Verdict::Inside && verdicts[b] == Verdict::Inside &&
      verdicts[c] == Verdict::Inside)
    {
      shown.push_back({ lattice.points[a], lattice.points[b], lattice.points[c] });
      corners.push_back({ valueAt(a), valueAt(b), valueAt(c) });
    }
  }
  return { std::move(shown), std::move(corners) };
}

class PiecesRun final : public TrianglesRun
{
public:
  PiecesRun(const TradeScene& scene, int level)
    : TrianglesRun(scene)
    , Parts(kFirstParts << level)
  {
  }

  TradeTime Measure() override
  {
    const FreshModel fresh(*scene_.shot);
    const Layer& layer = scene_.shot->scene.layers.front();
    const auto* given = dynamic_cast<const pixelexact::Triangles*>(layer.surface.get());
    const double pieces = given != nullptr ? static_cast<double>(given->Corners().size())
                                           : 2.0 * static_cast<double>(scene_.patches.size());
    const double count = pieces * Parts * Parts;
    RequireMemory(
      kBytes * count, Counted(static_cast<std::size_t>(count), "triangle"), "lower the level");
    TradeTime time;
    const PeakMemory memory;
    const auto make = [&]
    {
      const Timer timer;
      Lattice lattice;
      for (const BezierPatch& patch : scene_.patches)
      {
        lattice.Add(patch, Parts);
      }
      for (std::size_t k = 0; given != nullptr && k < given->Corners().size(); ++k)
      {
        lattice.Add(given->Corners()[k], Parts);
      }
      Linear.emplace(Valued(lattice, *fresh.model, layer));
      return timer.Seconds();
    };
    time.first = make();
    time.next = make();
    time.bytes = memory.Bytes().value_or(-1.0);
    return time;
  }

private:
  int Parts;
};
} // namespace

bool IsOfPieces(const TradeScene& scene)
{
  const Surface* const surface = scene.shot->scene.layers.front().surface.get();
  return dynamic_cast<const Triangles*>(surface) != nullptr ||
    dynamic_cast<const BezierPatches*>(surface) != nullptr;
}

std::unique_ptr<TradeRun> MakePiecesRun(const TradeScene& scene, const TradeSetting& setting)
{
  return std::make_unique<PiecesRun>(scene, setting.number);
}
} // namespace pixelexact
