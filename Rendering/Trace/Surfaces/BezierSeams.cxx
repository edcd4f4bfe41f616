// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/BezierSeams.h"

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/RayPlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
/// Steps of Newton's iteration along an edge.
constexpr int kSteps = 8;

std::vector<Vec3> EdgePoints(const BezierPatch& patch, int edge)
{
  const auto rows = static_cast<std::size_t>(patch.degree[0]) + 1;
  const auto columns = static_cast<std::size_t>(patch.degree[1]) + 1;
  const bool alongV = edge < 2;
  const std::size_t first = edge == 1 ? (rows - 1) * columns : (edge == 3 ? columns - 1 : 0);
  const std::size_t step = alongV ? 1 : columns;
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < (alongV ? columns : rows); ++k)
  {
    points.push_back(patch.points[first + k * step]);
  }
  return points;
}

BezierBend::Place PlaceOn(int edge, double along, const Vec3& position)
{
  const double end = edge % 2 == 0 ? 0.0 : 1.0;
  return edge < 2 ? BezierBend::Place{ position, end, along }
                  : BezierBend::Place{ position, along, end };
}

double AlongOf(int edge, const BezierBend::Place& place)
{
  return edge < 2 ? place.v : place.u;
}

BezierBend::Place PlaceOf(const SurfacePoint& point)
{
  return { point.position, 0.5 * (point.parameters[0] + 1.0), 0.5 * (point.parameters[1] + 1.0) };
}
} // namespace

BezierSeams::BezierSeams(std::span<const BezierPatch> patches)
  : Bends(patches.begin(), patches.end())
  , Beyond(patches.size())
{
  Join(patches);
}

void BezierSeams::Join(std::span<const BezierPatch> patches)
{
  // Edges by the corners at their ends, in order.
  std::map<std::array<double, 6>, std::vector<std::pair<std::int32_t, int>>> found;
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    for (int edge = 0; edge < kEdges; ++edge)
    {
      const std::vector<Vec3> points = EdgePoints(patches[p], edge);
      const std::array<double, 3> ends[2] = { { points.front().x, points.front().y,
                                                points.front().z },
        { points.back().x, points.back().y, points.back().z } };
      const auto& [first, last] = std::minmax(ends[0], ends[1]);
      found[{ first[0], first[1], first[2], last[0], last[1], last[2] }].emplace_back(
        static_cast<std::int32_t>(p), edge);
    }
  }
  for (const auto& [key, edges] : found)
  {
    if (edges.size() != 2)
    {
      continue;
    }
    const auto& [p, i] = edges[0];
    const auto& [q, j] = edges[1];
    const std::vector<Vec3> first = EdgePoints(patches[static_cast<std::size_t>(p)], i);
    std::vector<Vec3> second = EdgePoints(patches[static_cast<std::size_t>(q)], j);
    const bool same = first == second;
    std::ranges::reverse(second);
    if (same || first == second)
    {
      Beyond[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)] = { q, j, !same };
      Beyond[static_cast<std::size_t>(q)][static_cast<std::size_t>(j)] = { p, i, !same };
    }
  }
}

double BezierSeams::Sagitta(
  const Chord& chord, const SurfacePoint& from, const SurfacePoint& to) const
{
  if (from.piece < 0 || to.piece < 0)
  {
    return kInfinity;
  }
  const BezierBend::Place a = PlaceOf(from);
  const BezierBend::Place b = PlaceOf(to);
  if (from.piece == to.piece)
  {
    return BendOf(from.piece).Sagitta(chord, a, b);
  }
  const auto& beyond = Beyond[static_cast<std::size_t>(from.piece)];
  for (int edge = 0; edge < kEdges; ++edge)
  {
    if (beyond[static_cast<std::size_t>(edge)].patch == to.piece)
    {
      const double sagitta = Across(chord, from.piece, edge, a, b);
      if (std::isfinite(sagitta))
      {
        return sagitta;
      }
    }
  }
  return kInfinity;
}

double BezierSeams::Across(const Chord& chord, std::int32_t patch, int edge,
  const BezierBend::Place& from, const BezierBend::Place& to) const
{
  // Two paths meet where the edge crosses the rays' plane. Each is as far from its own chord as its
  // patch is. The distance of the two chords from the whole chord is at most that of the crossing.
  const RayPlane plane(chord);
  const Neighbour& next = Beyond[static_cast<std::size_t>(patch)][static_cast<std::size_t>(edge)];
  const BezierBend& bend = BendOf(patch);
  const double after = AlongOf(next.edge, to);
  double along = 0.5 * (AlongOf(edge, from) + (next.reversed ? 1.0 - after : after));
  for (int step = 0; step < kSteps; ++step)
  {
    const BezierBend::Place place = PlaceOn(edge, along, {});
    const BezierBend::View view = bend.At(place.u, place.v);
    const double slope =
      plane.Height(view.y + (edge < 2 ? view.yv : view.yu)) - plane.Height(view.y);
    along -= plane.Height(view.y) / slope;
  }
  // The comparison rejects a NaN.
  if (!(plane.IsKnown() && along > 0.0 && along < 1.0))
  {
    return kInfinity;
  }
  BezierBend::Place place = PlaceOn(edge, along, {});
  const Vec3 at = plane.Onto(bend.At(place.u, place.v).y);
  place.position = at;
  if (!(plane.Progress(from.position, at) > 0.0 && plane.Progress(at, to.position) > 0.0))
  {
    return kInfinity;
  }
  const BezierBend::Place beyond = PlaceOn(next.edge, next.reversed ? 1.0 - along : along, at);
  // Rays through the crossing lie between the two rays, so their turn is at most that of the chord.
  const double before = bend.Sagitta({ chord.a, chord.from, chord.b, at }, from, place);
  const double behind = BendOf(next.patch).Sagitta({ chord.a, at, chord.b, chord.to }, beyond, to);
  return std::max(before, behind) + plane.OffChord(at);
}
} // namespace pixelexact
