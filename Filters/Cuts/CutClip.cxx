// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/CutClip.h"

#include "Core/Location/Sample.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kHalvings = 16;

/// From a point inside to one that is not.
using Edge = std::pair<std::int64_t, std::int64_t>;

class Clipper
{
public:
  Clipper(const CutFunction& cut, const CutTriangles& whole, std::span<const Verdict> verdicts)
    : Cut(cut)
    , Whole(whole)
    , Verdicts(verdicts)
    , Number(whole.points.size(), -1)
  {
  }

  ClippedCut Clip(const Locator& locator)
  {
    FindPoints();
    Halve(locator);
    const auto first = static_cast<std::int64_t>(Result.kept.size());
    for (auto& triangle : Result.triangles)
    {
      for (std::int64_t& corner : triangle)
      {
        corner = corner < 0 ? first + (-1 - corner) : corner;
      }
    }
    return std::move(Result);
  }

private:
  [[nodiscard]] bool IsInside(std::int64_t point) const
  {
    return Verdicts[static_cast<std::size_t>(point)] == Verdict::Inside;
  }

  std::int64_t Kept(std::int64_t point)
  {
    std::int64_t& number = Number[static_cast<std::size_t>(point)];
    if (number < 0)
    {
      number = static_cast<std::int64_t>(Result.kept.size());
      Result.kept.push_back(point);
    }
    return number;
  }

  /// Of an edge; counted down from -1, for where the rim begins is not known yet.
  std::int64_t RimPoint(std::int64_t inside, std::int64_t outside)
  {
    const auto [at, isNew] =
      RimOf.try_emplace({ inside, outside }, -1 - static_cast<std::int64_t>(Edges.size()));
    if (isNew)
    {
      Edges.emplace_back(inside, outside);
    }
    return at->second;
  }

  void FindPoints()
  {
    for (std::array<std::int64_t, 3> t : Whole.triangles)
    {
      const auto inside =
        std::ranges::count_if(t, [this](std::int64_t point) { return IsInside(point); });
      if (inside == 0)
      {
        continue;
      }
      if (inside == 3)
      {
        Result.triangles.push_back({ Kept(t[0]), Kept(t[1]), Kept(t[2]) });
        continue;
      }
      ++Result.atTheRim;
      // The corner that is alone comes first.
      const bool alone = inside == 1;
      while (IsInside(t[0]) != alone || IsInside(t[1]) == alone)
      {
        std::rotate(t.begin(), t.begin() + 1, t.end());
      }
      if (alone)
      {
        Result.triangles.push_back({ Kept(t[0]), RimPoint(t[0], t[1]), RimPoint(t[0], t[2]) });
        continue;
      }
      const std::int64_t b = RimPoint(t[1], t[0]);
      const std::int64_t c = RimPoint(t[2], t[0]);
      Result.triangles.push_back({ b, Kept(t[1]), Kept(t[2]) });
      Result.triangles.push_back({ b, Kept(t[2]), c });
    }
  }

  /// On the surface, of each edge so far on its way, and a step more.
  void Advance(std::span<const double> reached, double step, std::span<Vec3> x) const
  {
    std::vector<double> lengths(Edges.size());
    for (std::size_t e = 0; e < Edges.size(); ++e)
    {
      const Vec3& a = Whole.points[static_cast<std::size_t>(Edges[e].first)];
      const Vec3& b = Whole.points[static_cast<std::size_t>(Edges[e].second)];
      x[e] = a + (reached[e] + step) * (b - a);
      lengths[e] = glm::distance(a, b);
    }
    const QuadricForm* form = Cut.Quadric();
    if (form == nullptr || !form->IsPlane())
    {
      BringOntoSurface(Cut, lengths, x);
    }
  }

  void Halve(const Locator& locator)
  {
    std::vector<double> reached(Edges.size(), 0.0);
    std::vector<Vec3> points(Edges.size());
    std::vector<Verdict> verdicts(Edges.size());
    for (const Edge& edge : Edges)
    {
      Result.rim.push_back(Whole.points[static_cast<std::size_t>(edge.first)]);
    }
    double step = 1.0;
    for (int i = 0; i < kHalvings && !Edges.empty(); ++i)
    {
      step /= 2.0;
      Advance(reached, step, points);
      SampleTarget target;
      target.verdict = verdicts;
      Sample(locator, nullptr, points, target);
      for (std::size_t e = 0; e < Edges.size(); ++e)
      {
        if (verdicts[e] == Verdict::Inside)
        {
          reached[e] += step;
          Result.rim[e] = points[e];
        }
      }
    }
  }

  const CutFunction& Cut;
  const CutTriangles& Whole;
  std::span<const Verdict> Verdicts;
  std::vector<std::int64_t> Number; ///< per point, -1: not kept
  std::map<Edge, std::int64_t> RimOf;
  std::vector<Edge> Edges;
  ClippedCut Result;
};
} // namespace

ClippedCut ClipToMesh(const CutFunction& cut, const CutTriangles& whole,
  std::span<const Verdict> verdicts, const Locator& locator)
{
  return Clipper(cut, whole, verdicts).Clip(locator);
}
} // namespace pixelexact
