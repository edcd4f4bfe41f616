// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Triangles.h"

#include "Core/Base/CheckedOut.h"
#include "Trace/Surfaces/Arguments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// A ray's own coordinates: its origin lies at 0, and its direction along the third. Corners are
/// moved and sheared to them, one by one, so that triangles agree on what they share (S. Woop,
/// C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013).
struct RayFrame
{
  Vec3 origin;
  int axes[3]; ///< the last one: along which the direction is longest
  double shear[2];

  RayFrame(const Vec3& from, const Vec3& direction)
    : origin(from)
  {
    const Vec3 size = glm::abs(direction);
    axes[2] = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    axes[0] = (axes[2] + 1) % 3;
    axes[1] = (axes[2] + 2) % 3;
    shear[0] = direction[axes[0]] / direction[axes[2]];
    shear[1] = direction[axes[1]] / direction[axes[2]];
  }

  [[nodiscard]] std::array<double, 2> Place(const Vec3& x) const
  {
    const Vec3 off = x - origin;
    return { off[axes[0]] - shear[0] * off[axes[2]], off[axes[1]] - shear[1] * off[axes[2]] };
  }
};

/// p.x q.y - p.y q.x: twice the area over the edge, whose sign is right, and which is 0 only where
/// it is 0; changes its sign, to the bit, where p and q change their places.
double Across(const std::array<double, 2>& p, const std::array<double, 2>& q)
{
  const double a = p[0] * q[1];
  const double b = p[1] * q[0];
  // Exact where the products are close; where they are not, their rounding errors do not count.
  return (a - b) + (std::fma(p[0], q[1], -a) - std::fma(p[1], q[0], -b));
}

/// Off by some roundings times the longest edge over the height on it.
Vec3 NormalOf(const Triangles::Triangle& triangle)
{
  const double size =
    std::max(LargestOf(triangle[1] - triangle[0]), LargestOf(triangle[2] - triangle[0]));
  const Vec3 p = (triangle[1] - triangle[0]) / size;
  const Vec3 q = (triangle[2] - triangle[0]) / size;
  const Vec3 across(Across({ p.y, p.z }, { q.y, q.z }), Across({ p.z, p.x }, { q.z, q.x }),
    Across({ p.x, p.y }, { q.x, q.y }));
  return across / glm::length(across);
}

struct Found
{
  double t;
  Vec3 position;
  std::int32_t triangle;
  double parameters[2];
  int shared; ///< corners of the feature that is met: 1: a corner, 2: an edge, 3: none but its own
  std::array<Vec3, 2> feature;
};

bool Before(const Vec3& a, const Vec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Where a ray meets a triangle; false where it does not.
bool MeetOne(const RayFrame& frame, const Vec3& direction, const Triangles::Triangle& triangle,
  std::int32_t number, Found& found)
{
  std::array<double, 2> place[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    place[k] = frame.Place(triangle[k]);
  }
  // Of each corner, over the edge across from it.
  const double weight[3] = { Across(place[1], place[2]), Across(place[2], place[0]),
    Across(place[0], place[1]) };
  const double* end = weight + 3;
  const bool left = std::all_of(weight, end, [](double w) { return w >= 0.0; });
  const bool right = std::all_of(weight, end, [](double w) { return w <= 0.0; });
  const double sum = weight[0] + weight[1] + weight[2];
  if (!(left || right))
  {
    return false;
  }
  const Vec3 normal = NormalOf(triangle);
  found.t = glm::dot(normal, triangle[0] - frame.origin) / glm::dot(normal, direction);
  // Seen from its edge it is a line, and without area it has no normal.
  if (sum == 0.0 || !std::isfinite(found.t))
  {
    return false;
  }
  const Vec3 onRay = frame.origin + found.t * direction;
  found.position = onRay + glm::dot(normal, triangle[0] - onRay) * normal;
  found.triangle = number;
  found.parameters[0] = weight[1] / sum;
  found.parameters[1] = weight[2] / sum;
  found.shared = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (weight[k] != 0.0)
    {
      if (found.shared < 2)
      {
        found.feature[static_cast<std::size_t>(found.shared)] = triangle[k];
      }
      ++found.shared;
    }
  }
  if (found.shared == 2 && Before(found.feature[1], found.feature[0]))
  {
    std::swap(found.feature[0], found.feature[1]);
  }
  return true;
}

bool SameFeature(const Found& a, const Found& b)
{
  return a.shared == b.shared && a.shared < 3 && a.feature[0] == b.feature[0] &&
    (a.shared == 1 || a.feature[1] == b.feature[1]);
}

struct Scratch
{
  std::vector<int> near;
  std::vector<Found> found;
};
} // namespace

Triangles::Triangles(std::vector<Triangle> triangles)
  : All(std::move(triangles))
{
  if (All.empty())
  {
    Refuse("triangles", "there are none");
  }
  std::vector<Box3> boxes;
  boxes.reserve(All.size());
  TheBounds = { All[0][0], All[0][0] };
  for (std::size_t i = 0; i < All.size(); ++i)
  {
    const auto& [a, b, c] = All[i];
    if (!IsFinite(a) || !IsFinite(b) || !IsFinite(c))
    {
      Refuse("triangles",
        ("a corner of triangle " + std::to_string(i) + " is not finite; remove it or mend it")
          .c_str());
    }
    boxes.push_back({ glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)) });
    TheBounds = { glm::min(TheBounds.lower, boxes[i].lower),
      glm::max(TheBounds.upper, boxes[i].upper) };
  }
  Hierarchy = std::make_unique<Bvh>(boxes, TheBounds);
}

void Triangles::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const CheckedOut<Scratch> scratch;
  auto& [near, found] = *scratch;
  for (int i = 0; i < rays.count; ++i)
  {
    const Vec3 origin(rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]);
    const Vec3 direction(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
    const auto segment = ClipRay(TheBounds, origin, direction, rays.tNear[i], rays.tFar[i]);
    if (!segment)
    {
      continue;
    }
    Hierarchy->QueryAlong(*segment, near);
    found.clear();
    const RayFrame frame(origin, direction);
    for (const int k : near)
    {
      Found one;
      if (MeetOne(frame, direction, All[static_cast<std::size_t>(k)], k, one) &&
        one.t >= rays.tNear[i] && one.t <= rays.tFar[i])
      {
        if (std::ranges::none_of(
              found, [&one](const Found& other) { return SameFeature(one, other); }))
        {
          found.push_back(one);
        }
      }
    }
    std::ranges::stable_sort(found, {}, &Found::t);
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      const HitLanes slot = hits.Slot(static_cast<int>(k));
      const PieceLanes piece = hits.Pieces(static_cast<int>(k));
      slot.t[i] = found[k].t;
      for (int d = 0; d < 3; ++d)
      {
        slot.position[d][i] = found[k].position[d];
      }
      piece.piece[i] = found[k].triangle;
      piece.parameters[0][i] = found[k].parameters[0];
      piece.parameters[1][i] = found[k].parameters[1];
    }
  }
}

Vec3 Triangles::Normal(const SurfacePoint& point) const
{
  return NormalOf(All[static_cast<std::size_t>(point.piece)]);
}
} // namespace pixelexact
