// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/JumpWalls.h"

#include "Core/Faces/BehindFace.h"
#include "Core/Location/Sample.h"
#include "Trace/Scene.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"
#include "Trace/Surfaces/Curved/HitsBehind.h"
#include "Trace/Surfaces/Curved/JumpFaces.h"
#include "Trace/Surfaces/IsoEquation.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Of values: far more than evaluation, and the place of a hit, leave of an error.
constexpr double kRounding = 1e-9;

std::vector<Box3> BoxesOf(const ElementIndex& index, std::span<const CurvedPart> parts)
{
  std::vector<Box3> boxes(parts.size());
  std::ranges::transform(parts, boxes.begin(),
    [&index](const CurvedPart& part) { return index.ElementBox(part.element); });
  return boxes;
}

/// What a hit is, by the values on both sides of its face. An enclosure that is not finite is
/// beside nothing and meets everything.
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
  , Jumps(faces.jumps)
{
}

std::vector<bool> JumpWalls::AreFar(
  const CurvedPart& part, double jump, std::span<const Vec3> xi) const
{
  const auto components = static_cast<std::size_t>(Sought.field->values.components);
  std::vector<double> values(components * xi.size());
  EvaluateAt(Behind.GetMesh(), *Sought.field, part.element, xi, values, {});
  std::vector<bool> far(xi.size());
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
    far[i] =
      std::fabs(value - Sought.value) > jump + kRounding * (length + std::fabs(Sought.value));
  }
  return far;
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

void JumpWalls::DropFar(
  const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const
{
  std::vector<Vec3> xi;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    xi.push_back(hits[k].xi);
  }
  const double jump = Jumps[static_cast<std::size_t>(hits[first].part)];
  const std::vector<bool> far = AreFar(part, jump, xi);
  std::size_t kept = first;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    if (!far[k - first])
    {
      hits[kept++] = hits[k];
    }
  }
  hits.resize(kept);
}

void JumpWalls::Review(
  const CurvedPart& part, std::vector<CurvedHit>& hits, std::size_t first) const
{
  DropFar(part, hits, first);
  if (hits.size() == first)
  {
    return;
  }
  const Interval value =
    Sought.component == kMagnitude ? Square(Interval(Sought.value)) : Interval(Sought.value);
  const std::vector<BehindFace> behind = HitsBehind(Behind, part, hits, first);
  std::vector<Vec3> xi;
  std::vector<Vec3> x;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    xi.push_back(hits[k].xi);
    x.push_back(hits[k].position);
  }
  const std::vector<Interval> mine = EnclosuresAt(part.element, xi, x);
  std::size_t kept = first;
  for (std::size_t k = first; k < hits.size(); ++k)
  {
    const std::size_t i = k - first;
    const BehindFace& at = behind[i];
    // What has a face on both sides is met from one of them.
    if (at.verdict == Verdict::Outside ||
      (at.verdict == Verdict::Inside && at.element < part.element))
    {
      continue;
    }
    Wall wall = Wall::Unknown;
    if (at.verdict == Verdict::Inside)
    {
      const Interval other =
        EnclosuresAt(at.element, std::span(&at.xi, 1), std::span(&x[i], 1)).front();
      wall = WallBetween(mine[i], other, value);
    }
    if (wall != Wall::None)
    {
      hits[kept] = hits[k];
      hits[kept].status = wall == Wall::Unknown ? HitStatus::Undecided : hits[k].status;
      ++kept;
    }
  }
  hits.resize(kept);
}

void JumpWalls::NormalsOf(
  const CurvedPart& part, std::span<const Vec3> xi, std::span<Vec3> normals) const
{
  FaceNormals(Equation().mesh, part, xi, normals);
}
} // namespace pixelexact
