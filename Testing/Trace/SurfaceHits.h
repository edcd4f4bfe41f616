// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TrueVerdicts.h"

#include "Trace/Surfaces/Triangles.h"

#include <algorithm>
#include <functional>
#include <vector>

// All hits of rays with surfaces, in long double.
namespace pixelexact::testing
{
/// The sign changes of a polynomial (constant first) between two numbers, in order, by bisection
/// between those of its derivative.
inline std::vector<long double> FindRealRoots(
  const std::vector<long double>& p, long double from, long double to)
{
  const auto at = [&p](long double s)
  {
    long double value = 0;
    for (auto c = p.rbegin(); c != p.rend(); ++c)
    {
      value = value * s + *c;
    }
    return value;
  };
  std::vector<long double> ends{ from };
  if (p.size() > 2)
  {
    std::vector<long double> slope;
    for (std::size_t k = 1; k < p.size(); ++k)
    {
      slope.push_back(static_cast<long double>(k) * p[k]);
    }
    const auto extrema = FindRealRoots(slope, from, to);
    ends.insert(ends.end(), extrema.begin(), extrema.end());
  }
  ends.push_back(to);
  std::vector<long double> roots;
  for (std::size_t k = 1; k < ends.size(); ++k)
  {
    long double low = ends[k - 1];
    long double high = ends[k];
    const bool below = at(low) < 0;
    if (below == (at(high) < 0))
    {
      continue;
    }
    for (int step = 0; step < 70; ++step)
    {
      const long double middle = (low + high) / 2;
      ((at(middle) < 0) == below ? low : high) = middle;
    }
    roots.push_back((low + high) / 2);
  }
  return roots;
}

inline LongHits TorusHits(const Vec3& centre, const Vec3& axis, double R, double r)
{
  return [c = ToLong(centre), a = Unit(ToLong(axis)), R = static_cast<long double>(R),
           r = static_cast<long double>(r)](const LongRay& ray)
  {
    // (|y|^2 + R^2 - r^2)^2 = 4 R^2 (|y|^2 - (a.y)^2), about the ray's point closest to the centre.
    const long double t0 = Dot(Minus(c, ray.origin), ray.direction);
    const LongVec3 y = Minus(Plus(ray.origin, Times(t0, ray.direction)), c);
    const long double yy = Dot(y, y);
    const long double ya = Dot(y, a);
    const long double da = Dot(ray.direction, a);
    const long double k = yy + R * R - r * r;
    const long double four = 4 * R * R;
    if (yy > (R + r) * (R + r))
    {
      return std::vector<long double>();
    }
    auto roots = FindRealRoots(
      { k * k - four * (yy - ya * ya), 2 * four * ya * da, 2 * k - four * (1 - da * da), 0, 1 },
      -2 * (R + r), 2 * (R + r));
    for (long double& s : roots)
    {
      s += t0;
    }
    return roots;
  };
}

/// The hits of the box |x|, |y|, |z| <= half.
inline LongHits BoxHits(double half)
{
  return [h = static_cast<long double>(half)](const LongRay& ray)
  {
    long double enter = -1e30L;
    long double leave = 1e30L;
    for (std::size_t d = 0; d < 3; ++d)
    {
      const long double s = (-h - ray.origin[d]) / ray.direction[d];
      const long double t = (h - ray.origin[d]) / ray.direction[d];
      enter = std::max(enter, std::min(s, t));
      leave = std::min(leave, std::max(s, t));
    }
    return enter < leave ? std::vector{ enter, leave } : std::vector<long double>();
  };
}

/// The parts' hits at which `inside` changes.
inline LongHits BooleanHits(
  std::vector<LongHits> parts, std::function<bool(const LongVec3& x)> inside)
{
  return [parts = std::move(parts), inside = std::move(inside)](const LongRay& ray)
  {
    std::vector<long double> all;
    for (const LongHits& part : parts)
    {
      const auto hits = part(ray);
      all.insert(all.end(), hits.begin(), hits.end());
    }
    std::ranges::sort(all);
    std::vector<long double> changes;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const auto at = [&](long double t)
      { return inside(Plus(ray.origin, Times(t, ray.direction))); };
      const bool before = k > 0 && at((all[k - 1] + all[k]) / 2);
      const bool after = k + 1 < all.size() && at((all[k] + all[k + 1]) / 2);
      if (before != after)
      {
        changes.push_back(all[k]);
      }
    }
    return changes;
  };
}

inline LongHits DiscHits(const Vec3& centre, const Vec3& normal, double radius)
{
  return [=, plane = PlaneHits(centre, normal)](const LongRay& ray)
  {
    auto hits = plane(ray);
    const LongVec3 off = Minus(Plus(ray.origin, Times(hits[0], ray.direction)), ToLong(centre));
    if (Dot(off, off) > static_cast<long double>(radius) * radius)
    {
      hits.clear();
    }
    return hits;
  };
}

inline LongHits TriangleHits(const std::vector<Triangles::Triangle>& triangles)
{
  return [triangles](const LongRay& ray)
  {
    std::vector<long double> hits;
    for (const auto& [a, b, c] : triangles)
    {
      const LongVec3 p = Minus(ToLong(b), ToLong(a));
      const LongVec3 q = Minus(ToLong(c), ToLong(a));
      const LongVec3 o = Minus(ray.origin, ToLong(a));
      const LongVec3 across = Cross(ray.direction, q);
      const long double volume = Dot(p, across);
      const long double u = Dot(o, across) / volume;
      const LongVec3 other = Cross(o, p);
      const long double v = Dot(ray.direction, other) / volume;
      if (u >= 0 && v >= 0 && u + v <= 1)
      {
        hits.push_back(Dot(q, other) / volume);
      }
    }
    std::ranges::sort(hits);
    return hits;
  };
}
} // namespace pixelexact::testing
