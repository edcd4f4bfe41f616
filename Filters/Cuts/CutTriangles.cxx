// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/CutTriangles.h"

#include "Core/Base/Counted.h"
#include "Core/Location/Sample.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr const char* kRemedy = "lower the resolution";
/// Bytes per point of a surface with two triangles a point, each of three 8-byte indices.
constexpr double kBytesOfTriangles = 48.0;

double Longest(const Vec3& sides)
{
  return std::max({ sides.x, sides.y, sides.z });
}

/// Points where a plane crosses the edges of a box.
std::vector<Vec3> CrossingsOf(const Vec3& point, const Vec3& normal, const Box3& box)
{
  std::vector<Vec3> crossings;
  const auto corner = [&box](int c)
  {
    return Vec3((c & 1) != 0 ? box.upper.x : box.lower.x, (c & 2) != 0 ? box.upper.y : box.lower.y,
      (c & 4) != 0 ? box.upper.z : box.lower.z);
  };
  for (int a = 0; a < 8; ++a)
  {
    for (int side = 1; side < 8; side *= 2)
    {
      const Vec3 p = corner(a);
      const Vec3 q = corner(a | side);
      const double atP = glm::dot(normal, p - point);
      const double atQ = glm::dot(normal, q - point);
      if ((a & side) == 0 && (atP <= 0.0) != (atQ <= 0.0))
      {
        crossings.push_back(p + (q - p) * (atP / (atP - atQ)));
      }
    }
  }
  return crossings;
}

CutTriangles PlaneGrid(
  const ImplicitPolynomial& form, const Box3& box, int resolution, double bytesPerPoint)
{
  const double length = glm::length(form.a.g);
  const Vec3 normal = form.a.g / length;
  const Vec3 point = form.origin - normal * (form.a.c / length);
  // The first direction in the plane is along the axis with the smallest normal component.
  const Vec3 slant = glm::abs(normal);
  const int axis = slant.x <= slant.y && slant.x <= slant.z ? 0 : (slant.y <= slant.z ? 1 : 2);
  Vec3 along(0.0);
  along[axis] = 1.0;
  const Vec3 u = glm::normalize(along - normal * normal[axis]);
  const Vec3 v = glm::cross(normal, u);

  CutTriangles cut;
  double lower[2] = { kInfinity, kInfinity };
  double upper[2] = { -kInfinity, -kInfinity };
  for (const Vec3& x : CrossingsOf(point, normal, box))
  {
    const double at[2] = { glm::dot(u, x - point), glm::dot(v, x - point) };
    for (int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], at[d]);
      upper[d] = std::max(upper[d], at[d]);
    }
  }
  const double sides[2] = { upper[0] - lower[0], upper[1] - lower[1] };
  const double longest = std::max(sides[0], sides[1]);
  if (!(longest > 0.0))
  {
    return cut;
  }
  std::int64_t n[2];
  for (int d = 0; d < 2; ++d)
  {
    n[d] = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(resolution * (sides[d] / longest) - 1e-9)));
  }
  const double points = static_cast<double>(n[0] + 1) * static_cast<double>(n[1] + 1);
  RequireMemory(points * (sizeof(Vec3) + kBytesOfTriangles + bytesPerPoint),
    Counted(n[0] * n[1], "square") + " on the plane", kRemedy);
  cut.points.reserve(static_cast<std::size_t>(points));
  for (std::int64_t j = 0; j <= n[1]; ++j)
  {
    for (std::int64_t i = 0; i <= n[0]; ++i)
    {
      const double s = lower[0] + sides[0] * static_cast<double>(i) / static_cast<double>(n[0]);
      const double t = lower[1] + sides[1] * static_cast<double>(j) / static_cast<double>(n[1]);
      cut.points.push_back(point + u * s + v * t);
    }
  }
  cut.triangles.reserve(static_cast<std::size_t>(2 * n[0] * n[1]));
  for (std::int64_t j = 0; j < n[1]; ++j)
  {
    for (std::int64_t i = 0; i < n[0]; ++i)
    {
      const std::int64_t a = j * (n[0] + 1) + i;
      const std::int64_t b = a + n[0] + 1;
      cut.triangles.push_back({ a, a + 1, b + 1 });
      cut.triangles.push_back({ a, b + 1, b });
    }
  }
  return cut;
}

constexpr int kSubdivisions = 16;

/// An edge from a point inside the mesh to one that is not inside.
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
    Subdivide(locator);
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

  /// The rim point of an edge. Numbers count down from -1 until the number of kept points is known.
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
      // Rotates the triangle so that the corner that differs from the other two comes first.
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

  /// Computes the points on the surface that are `step` beyond the positions `reached` along their
  /// edges (both in units of the edge).
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
    const ImplicitPolynomial* form = Cut.Polynomial();
    if (form == nullptr || !form->IsPlane())
    {
      BringOntoSurface(Cut, lengths, x);
    }
  }

  void Subdivide(const Locator& locator)
  {
    std::vector<double> reached(Edges.size(), 0.0);
    std::vector<Vec3> points(Edges.size());
    std::vector<Verdict> verdicts(Edges.size());
    for (const Edge& edge : Edges)
    {
      Result.rim.push_back(Whole.points[static_cast<std::size_t>(edge.first)]);
    }
    double step = 1.0;
    for (int i = 0; i < kSubdivisions && !Edges.empty(); ++i)
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

std::int64_t BringOntoSurface(
  const CutFunction& cut, std::span<const double> reach, std::span<Vec3> x)
{
  constexpr int kMaxSteps = 50;
  std::int64_t off = 0;
  std::vector<std::size_t> moving(x.size());
  std::iota(moving.begin(), moving.end(), std::size_t{ 0 });
  std::vector<Vec3> at(x.begin(), x.end());
  std::vector<double> values(x.size());
  std::vector<Vec3> gradients(x.size());
  for (int i = 0; i < kMaxSteps && !moving.empty(); ++i)
  {
    cut.Values(at, values);
    cut.Gradients(at, gradients);
    std::size_t next = 0;
    for (std::size_t k = 0; k < moving.size(); ++k)
    {
      Vec3& start = x[moving[k]];
      const double most = reach[moving[k]];
      const Vec3 step = gradients[k] * (values[k] / glm::dot(gradients[k], gradients[k]));
      const bool arrived = values[k] == 0.0 || glm::length(step) <= 1e-15 * most;
      const Vec3 then = arrived ? at[k] : at[k] - step;
      if (!arrived && !(glm::distance(then, start) <= most))
      {
        ++off;
      }
      // Rounding of large coordinates limits how small steps become.
      else if (arrived || glm::length(step) <= 4e-16 * Longest(glm::abs(then)) ||
        i + 1 == kMaxSteps)
      {
        start = then;
      }
      else
      {
        moving[next] = moving[k];
        at[next++] = then;
      }
    }
    moving.resize(next);
    at.resize(next);
    values.resize(next);
    gradients.resize(next);
  }
  return off;
}

CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress)
{
  if (!(box.lower.x <= box.upper.x) || !(Longest(box.upper - box.lower) > 0.0))
  {
    return {};
  }
  const ImplicitPolynomial* form = cut.Polynomial();
  return form != nullptr && form->IsPlane()
    ? PlaneGrid(*form, box, resolution, bytesPerPoint)
    : MarchCubes(cut, box, resolution, kBytesOfTriangles + bytesPerPoint, progress);
}

ClippedCut ClipToMesh(const CutFunction& cut, const CutTriangles& whole,
  std::span<const Verdict> verdicts, const Locator& locator)
{
  return Clipper(cut, whole, verdicts).Clip(locator);
}
} // namespace pixelexact
