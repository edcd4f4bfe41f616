// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/PartSagitta.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Math/Rounding.h"
#include "Trace/Scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
/// Largest distance, in xi, of a hit from its face's plane.
constexpr double kOnFace = 1e-9;

/// Largest distance, relative to the chord, of the points where two sheets of one surface leave
/// their elements.
constexpr double kApart = 1e-3;

/// Limit for subdivisions of nodes in the test of a region.
constexpr int kSubdivisions = 12;

/// Bounds the distance from a straight line to a sheet that leaves its element, or to a chord on
/// it, from the distance `beside` at the line's end. The rays are nearly parallel.
double Off(const SheetExit& exit, double sagitta, const Vec3& chord, const Vec3& turn)
{
  const double sine = glm::length(glm::cross(exit.point.direction, chord)) / glm::length(chord);
  const double least = sine - glm::length(turn);
  return least > 0.0 ? sagitta + exit.beside * sine / least : kInfinity;
}
} // namespace

PartSagitta::PartSagitta(
  const ElementIndex& index, const CurvedEquation& equation, std::span<const CurvedPart> parts)
  : Index(index)
  , Equation(equation)
  , Bounds(static_cast<std::size_t>(index.GetMesh().Elements()))
{
  if (equation.field == nullptr)
  {
    Faces.assign(parts.begin(), parts.end());
    const auto order = [](const CurvedPart& part) { return std::pair(part.element, part.face); };
    std::ranges::sort(Faces, {}, order);
    const auto same = [&order](const CurvedPart& a, const CurvedPart& b)
    { return order(a) == order(b); };
    Faces.erase(std::unique(Faces.begin(), Faces.end(), same), Faces.end());
  }
}

const EdgeBounds& PartSagitta::BoundsOf(int element) const
{
  return Bounds.Get(static_cast<std::size_t>(element),
    [&]
    {
      const ElementBounds& own = Index.BoundsOf(element);
      return Equation.field == nullptr
        ? std::make_unique<const EdgeBounds>(Equation.mesh, own, element)
        : std::make_unique<const EdgeBounds>(Equation.mesh, own, element, *Equation.field,
            Equation.component == kMagnitude ? -1 : Equation.component);
    });
}

PartSagitta::End PartSagitta::EndOf(const Ray& ray, const SurfacePoint& at) const
{
  End end;
  end.bounds = &BoundsOf(at.element);
  end.point.x = at.position;
  end.point.xi = at.xi;
  end.point.direction = ray.direction;
  const Vec3 from = at.position - ray.origin;
  end.point.distance = glm::length(from);
  end.point.off = glm::distance(from, glm::dot(from, ray.direction) * ray.direction) +
    32.0 * kUnitRoundoff * (glm::length(ray.origin) + glm::length(at.position));
  if (Equation.field != nullptr)
  {
    end.sheets[end.count++] = { -1, Equation.value };
    return end;
  }
  const auto planes = FacePlanesOf(Equation.mesh.ShapeOf(at.element));
  for (const CurvedPart& part : FacesOf(at.element))
  {
    if (std::fabs(planes[static_cast<std::size_t>(part.face)].Distance(at.xi)) <= kOnFace)
    {
      end.sheets[end.count++] = { part.face };
    }
  }
  return end;
}

std::span<const CurvedPart> PartSagitta::FacesOf(int element) const
{
  const auto first = std::ranges::lower_bound(Faces, element, {}, &CurvedPart::element);
  const auto last = std::ranges::upper_bound(Faces, element, {}, &CurvedPart::element);
  return { first, last };
}

bool PartSagitta::MayMeet(const WideOutline& region, EdgeWork* work) const
{
  const EdgeEffort effort{ kSubdivisions, 0, work };
  std::vector<int> elements;
  Index.FindNear(BoxOf(region), elements);
  return std::ranges::any_of(elements,
    [&](int element)
    {
      if (Equation.field != nullptr)
      {
        const EdgeBounds& bounds = BoundsOf(element);
        return bounds.HasValues() && bounds.MayMeet({ -1, Equation.value }, region, effort);
      }
      return std::ranges::any_of(FacesOf(element),
        [&](const CurvedPart& part)
        { return BoundsOf(element).MayMeet({ part.face }, region, effort); });
    });
}

double PartSagitta::Of(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  End ends[2] = { EndOf(a, atA), EndOf(b, atB) };
  for (const Sheet& sheet : ends[0].Sheets())
  {
    const bool isOnBoth = atA.element == atB.element &&
      std::ranges::find(ends[1].Sheets(), sheet.face, &Sheet::face) != ends[1].Sheets().end();
    const double sagitta =
      isOnBoth ? ends[0].bounds->Sagitta(sheet, ends[0].point, ends[1].point) : kInfinity;
    if (std::isfinite(sagitta))
    {
      return sagitta;
    }
  }
  // Follows each of the two sheets to where it leaves its element. The ray through a point between
  // the two is known if all rays come from one point, or are parallel.
  if (a.origin != b.origin)
  {
    if (a.direction != b.direction)
    {
      return kInfinity;
    }
    ends[0].point.distance = ends[1].point.distance = 1.0;
  }
  double least = kInfinity;
  for (const Sheet& first : ends[0].Sheets())
  {
    const Reach there = ReachOf(ends[0], first, ends[1].point);
    for (const Sheet& second : ends[1].Sheets())
    {
      const Reach back =
        std::isfinite(there.off) ? ReachOf(ends[1], second, ends[0].point) : Reach{};
      // Together the two sheets reach all rays. They must also be one surface; otherwise one may
      // hide the other.
      const double apart = kApart * glm::distance(atA.position, atB.position) +
        kOnFace *
          (Equation.mesh.size[static_cast<std::size_t>(atA.element)] +
            Equation.mesh.size[static_cast<std::size_t>(atB.element)]);
      if (there.part + back.part >= 1.0 && glm::distance(there.end, back.end) <= apart)
      {
        least = std::min(least, std::max(there.off, back.off));
      }
    }
  }
  return least;
}

PartSagitta::Reach PartSagitta::ReachOf(
  const End& from, const Sheet& sheet, const SheetPoint& towards)
{
  const auto exit = from.bounds->ExitOf(sheet, from.point, towards);
  return exit && exit->part > 0.0 ? Reach{ exit->part, exit->point.x,
    Off(*exit, from.bounds->Sagitta(sheet, from.point, exit->point), towards.x - from.point.x,
      towards.direction - from.point.direction) }
                                  : Reach{};
}
} // namespace pixelexact
