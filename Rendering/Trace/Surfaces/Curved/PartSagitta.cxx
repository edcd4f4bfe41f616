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
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// In xi: how far from a face's plane a hit of it may be.
constexpr double kOnFace = 1e-9;

/// How far a sheet that leaves its element, or a chord on it, is off the straight line between two
/// points that is `beside` off at its end: the rays are nearly parallel.
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
    const auto repeated = std::ranges::unique(Faces, {}, order);
    Faces.erase(repeated.begin(), repeated.end());
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
  for (const CurvedPart& part :
    std::ranges::equal_range(Faces, at.element, {}, &CurvedPart::element))
  {
    if (std::fabs(planes[static_cast<std::size_t>(part.face)].Distance(at.xi)) <= kOnFace)
    {
      end.sheets[end.count++] = { part.face };
    }
  }
  return end;
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
  // From one sheet to the next: each up to where it leaves its element. Which ray goes through a
  // point between the two is known where all come from one point, or are parallel.
  if (a.origin != b.origin)
  {
    if (a.direction != b.direction)
    {
      return kInfinity;
    }
    ends[0].point.distance = ends[1].point.distance = 1.0;
  }
  const Vec3 chord = atB.position - atA.position;
  double part = 0.0;
  double most = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const End& from = ends[k];
    double best = kInfinity;
    double reached = 0.0;
    for (const Sheet& sheet : from.Sheets())
    {
      const auto exit = from.bounds->ExitOf(sheet, from.point, ends[1 - k].point);
      const double off = exit && exit->part > 0.0
        ? Off(*exit, from.bounds->Sagitta(sheet, from.point, exit->point), chord,
            b.direction - a.direction)
        : kInfinity;
      if (off < best)
      {
        best = off;
        reached = exit->part;
      }
    }
    most = std::max(most, best);
    part += reached;
  }
  // Together they reach all rays.
  return part >= 1.0 ? most : kInfinity;
}
} // namespace pixelexact
