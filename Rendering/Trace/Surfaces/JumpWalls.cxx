// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/JumpWalls.h"

#include "Core/Faces/BehindFace.h"
#include "Core/Location/Sample.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/HitsBehind.h"
#include "Trace/Surfaces/Curved/JumpFaces.h"
#include "Trace/Surfaces/IsoSurface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pixelexact
{
namespace
{
/// Relative to values: far above the errors of evaluation and of a hit's place.
constexpr double kJumpRounding = 1e-9;

std::vector<Box3> BoxesOf(const ElementIndex& index, std::span<const CurvedPart> parts)
{
  std::vector<Box3> boxes(parts.size());
  std::ranges::transform(parts, boxes.begin(),
    [&index](const CurvedPart& part) { return index.ElementBox(part.element); });
  return boxes;
}

/// Classification of a hit by the values on both sides of its face. An enclosure that is not finite
/// overlaps everything.
enum class Wall
{
  None,
  Here,
  Unknown
};

Wall WallBetween(const Interval& mine, const Interval& other, const Interval& value)
{
  const auto below = [&value](const Interval& v) { return v.upper < value.lower; };
  const auto above = [&value](const Interval& v) { return v.lower > value.upper; };
  if ((below(mine) && above(other)) || (above(mine) && below(other)))
  {
    return Wall::Here;
  }
  if ((below(mine) && below(other)) || (above(mine) && above(other)))
  {
    return Wall::None;
  }
  const bool known = mine.IsFinite() && other.IsFinite();
  return known && !Intersect(mine, other).IsEmpty() ? Wall::None : Wall::Unknown;
}
} // namespace

JumpWalls::JumpWalls(
  const Locator& locator, const FaceTable& table, const Field& field, int component, double value)
  : JumpWalls(locator,
      JumpFaces(locator, table, IsoEquation(locator.GetMesh(), field, component, value)),
      IsoEquation(locator.GetMesh(), field, component, value))
{
}

JumpWalls::JumpWalls(const Locator& locator, const JumpFaces& faces, const CurvedEquation& equation)
  : CurvedSurface({ locator.GetMesh() }, faces.parts, BoxesOf(locator.Index(), faces.parts))
  , Behind(locator)
  , Sought(equation)
  , Across(faces.across)
{
}

std::vector<BehindFace> JumpWalls::BehindHits(
  const CurvedPart& part, const std::vector<CurvedHit>& hits, std::size_t first) const
{
  const AcrossFace& across = Across[static_cast<std::size_t>(hits[first].part)];
  if (across.element < 0)
  {
    return HitsBehind(Behind, part, hits, first);
  }
  std::vector<BehindFace> behind;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    behind.push_back({ Verdict::Inside, across.element, across.At(hits[k].xi) });
  }
  return behind;
}

std::vector<int> JumpWalls::SidesAt(int element, std::span<const Vec3> xi) const
{
  const auto components = static_cast<std::size_t>(Sought.field->values.components);
  std::vector<double> values(components * xi.size());
  EvaluateAt(Behind.GetMesh(), *Sought.field, element, xi, values, {});
  std::vector<int> sides(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const auto of = std::span(values).subspan(components * i, components);
    double length = 0.0;
    for (const double one : of)
    {
      length = std::hypot(length, one);
    }
    const double value =
      Sought.component == kMagnitude ? length : of[static_cast<std::size_t>(Sought.component)];
    const double off = value - Sought.value;
    const double least = kJumpRounding * (length + std::fabs(Sought.value));
    sides[i] = off > least ? 1 : off < -least ? -1 : 0;
  }
  return sides;
}

std::vector<Interval> JumpWalls::EnclosuresAt(
  int element, std::span<const Vec3> xi, std::span<const Vec3> x) const
{
  const auto components = static_cast<std::size_t>(Sought.field->values.components);
  std::vector<double> lower(components * xi.size());
  std::vector<double> upper(lower.size());
  EncloseAt(Behind.GetMesh(), *Sought.field, element, xi, x, lower, upper);
  std::vector<Interval> enclosures(xi.size());
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    const auto of = [&](std::size_t c) -> Interval {
      return { lower[components * i + c], upper[components * i + c] };
    };
    if (Sought.component != kMagnitude)
    {
      enclosures[i] = of(static_cast<std::size_t>(Sought.component));
      continue;
    }
    for (std::size_t c = 0; c < components; ++c)
    {
      enclosures[i] += Square(of(c));
    }
  }
  return enclosures;
}

/// A hit, and the point on the other side.
struct JumpWalls::OneHit
{
  CurvedHit hit;
  BehindFace behind;
};

void JumpWalls::Review(
  const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const
{
  const Interval value =
    Sought.component == kMagnitude ? Square(Interval(Sought.value)) : Interval(Sought.value);
  const auto xiOf = [](const auto& all, auto member)
  {
    std::vector<Vec3> xi(all.size());
    std::ranges::transform(all, xi.begin(), member);
    return xi;
  };
  // A face of two elements is met from one of them.
  std::vector<OneHit> met;
  const std::vector<BehindFace> behind = BehindHits(part, hits, first);
  for (std::size_t i = 0; i < behind.size(); ++i)
  {
    if (behind[i].verdict == Verdict::Unknown ||
      (behind[i].verdict == Verdict::Inside && behind[i].element > part.element))
    {
      met.push_back({ hits[first + i], behind[i] });
    }
  }
  hits.resize(first);
  // Hits that share the element behind are evaluated together.
  for (std::size_t begin = 0, end = 0; begin < met.size(); begin = end)
  {
    const int other = met[begin].behind.element;
    while (end < met.size() && met[end].behind.element == other)
    {
      ++end;
    }
    const auto some = std::span(met).subspan(begin, end - begin);
    const auto mine = xiOf(some, [](const OneHit& one) { return one.hit.xi; });
    if (other < 0)
    {
      std::ranges::transform(some, std::back_inserter(hits),
        [](OneHit& one)
        {
          one.hit.status = HitStatus::Undecided;
          return one.hit;
        });
      continue;
    }
    const auto theirs = xiOf(some, [](const OneHit& one) { return one.behind.xi; });
    const std::vector<int> here = SidesAt(part.element, mine);
    const std::vector<int> there = SidesAt(other, theirs);
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      if (here[i] != 0 && here[i] == there[i])
      {
        continue;
      }
      CurvedHit hit = some[i].hit;
      const std::span<const Vec3> x(&hit.position, 1);
      const Wall wall = WallBetween(EnclosuresAt(part.element, std::span(&mine[i], 1), x).front(),
        EnclosuresAt(other, std::span(&theirs[i], 1), x).front(), value);
      if (wall != Wall::None)
      {
        hit.status = wall == Wall::Unknown ? HitStatus::Undecided : hit.status;
        hits.push_back(hit);
      }
    }
  }
}
} // namespace pixelexact
