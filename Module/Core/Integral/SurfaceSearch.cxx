// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/SurfaceSearch.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
/// Values are taken at so many places along each variable of a parametrised surface.
constexpr int kPlacesAlong = 5;
/// Bounds the rounding of a model's value at a place, relative to its norm: 45 terms of Chebyshev
/// polynomials of degree 8.
constexpr double kPlaceRounding = 0x1p-44;

using Line = std::array<double, ChebyshevModel::kDegree + 1>;

Line ChebyshevLine(double s)
{
  Line line{ 1.0, s };
  for (std::size_t i = 2; i < line.size(); ++i)
  {
    line[i] = 2.0 * s * line[i - 1] - line[i - 2];
  }
  return line;
}

/// Encloses a model's value.
Interval ValueAt(const ChebyshevModel& model, const Line& s, const Line& t)
{
  double sum = 0.0;
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      sum += model.c[ChebyshevModel::Index(i, j)] * s[static_cast<std::size_t>(i)] *
        t[static_cast<std::size_t>(j)];
    }
  }
  const double error = Up(model.error + kPlaceRounding * model.Norm());
  return rounding::Outward(sum - error, sum + error);
}
} // namespace

bool RangeEnd::Take(const Attained& other, int of)
{
  if (std::isnan(other.value) || (IsKnown() && !(other.value < least.value)))
  {
    return false;
  }
  least = other;
  part = of;
  return true;
}

double KnownRange::Gap(double tolerance) const
{
  // Gaps below this part of the largest magnitude are rounding.
  constexpr double kMagnitudeGap = 0x1p-40;
  if (!lower.IsKnown() || !upper.IsKnown())
  {
    return 0.0;
  }
  const double low = lower.least.value;
  const double high = -upper.least.value;
  return std::max(tolerance * std::max(high - low, 0.0),
    kMagnitudeGap * std::max(std::fabs(low), std::fabs(high)));
}

SurfaceSearch::SurfaceSearch(const IntegralQuestion& question, int component, int element, int face)
  : Element(element)
  , question_(question)
  , Component(component)
  , Face(face)
{
  ElementFunctions functions(question, element);
  Finite = functions.IsFinite();
  if (!Finite || functions.IsTooHigh())
  {
    return;
  }
  for (PieceBox piece : functions.Pieces())
  {
    if (face < 0)
    {
      Tolerance = std::max(Tolerance, CutTolerance(functions, piece));
      Look(functions, piece);
      continue;
    }
    const ShapeFace& end = FacesOf(functions.GetShape())[static_cast<std::size_t>(face)];
    if (functions.IsOnCube(piece, end.direction, end.upper))
    {
      piece.lower[end.direction] = piece.upper[end.direction] = end.upper ? 1.0 : -1.0;
      Look(functions, piece);
    }
  }
}

Interval SurfaceSearch::Outer() const
{
  Interval all(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const ExtremeBox& box : Boxes)
  {
    all.lower = std::min(all.lower, box.outer.lower);
    all.upper = std::max(all.upper, box.outer.upper);
  }
  return all;
}

bool SurfaceSearch::Refine(const KnownRange& known, double tolerance, int boxes)
{
  KnownRange range = known;
  const auto excess = [&range](const ExtremeBox& box)
  {
    const double below =
      range.lower.IsKnown() ? range.lower.least.value - box.outer.lower : kInfinity;
    const double above =
      range.upper.IsKnown() ? range.upper.least.value + box.outer.upper : kInfinity;
    return std::max(below, above);
  };
  std::optional<ElementFunctions> functions;
  const std::int64_t last = Count + boxes;
  while (true)
  {
    range.lower.Take(Low.least, 0);
    range.upper.Take(High.least, 0);
    const double gap = range.Gap(tolerance);
    const auto worst = std::ranges::max_element(Boxes, {},
      [&](const ExtremeBox& box) { return box.direction < 0 ? -kInfinity : excess(box); });
    const bool isDone =
      std::ranges::all_of(Boxes, [&](const ExtremeBox& box) { return excess(box) <= gap; });
    if (isDone || worst->direction < 0 || !(excess(*worst) > gap) || Count >= last)
    {
      return isDone;
    }
    if (!functions)
    {
      functions.emplace(question_, Element);
    }
    const ExtremeBox box = *worst;
    *worst = Boxes.back();
    Boxes.pop_back();
    const int d = box.direction;
    const double middle = box.box.lower[d] + kBoxDivision * (box.box.upper[d] - box.box.lower[d]);
    PieceBox half = box.box;
    half.upper[d] = middle;
    Look(*functions, half);
    half = box.box;
    half.lower[d] = middle;
    Look(*functions, half);
  }
}

void SurfaceSearch::Look(ElementFunctions& functions, const PieceBox& box)
{
  ++Count;
  if (IsClippedOff(functions, box))
  {
    return;
  }
  if (Face >= 0)
  {
    LookAt(ValuesOnFace(functions, Face, box), box);
    return;
  }
  const CutInBox found = LookAtCut(functions, box, Tolerance);
  if (found.empty || IsClippedOff(functions, found.box))
  {
    return;
  }
  std::vector<SurfaceValues> graphs;
  bool resolved = found.decided;
  for (std::size_t g = 0; g < found.graphs.size() && resolved; ++g)
  {
    auto values = ValuesOn(functions, found.graphs[g]);
    resolved = values.has_value();
    if (resolved)
    {
      graphs.push_back(std::move(*values));
    }
  }
  if (!resolved)
  {
    const int bent = found.decided ? -1 : MostBentSide(functions, found.box);
    Boxes.push_back({ found.box, RangeIn(functions, found.box),
      bent >= 0 ? bent : LongestSide(functions, found.box) });
    return;
  }
  for (std::size_t g = 0; g < graphs.size(); ++g)
  {
    LookAt(graphs[g], found.graphs[g].box);
  }
  for (const CutGraph& strip : found.rest)
  {
    Boxes.push_back(
      { strip.box, RangeIn(functions, strip.box), LongestSide(functions, strip.box) });
  }
}

Interval SurfaceSearch::RangeIn(ElementFunctions& functions, const PieceBox& box) const
{
  if (Component != FieldFunction::kNorm)
  {
    return FieldRange(functions, box, Component);
  }
  Interval square(0.0);
  for (int c = 0; c < question_.Components(); ++c)
  {
    square += Square(FieldRange(functions, box, c));
  }
  return Sqrt(square);
}

Interval SurfaceSearch::FromModel(const Interval& value) const
{
  return Component != FieldFunction::kNorm
    ? value
    : Sqrt(Interval(std::max(value.lower, 0.0), std::max(value.upper, 0.0)));
}

void SurfaceSearch::LookAt(const SurfaceValues& surface, const PieceBox& box)
{
  for (const ChebyshevModel& clip : surface.clips)
  {
    if (clip.TightRange().lower > 0.0)
    {
      return;
    }
  }
  ChebyshevModel model;
  if (Component != FieldFunction::kNorm)
  {
    model = surface.values[static_cast<std::size_t>(Component)];
  }
  for (std::size_t c = 0; c < surface.values.size() && Component == FieldFunction::kNorm; ++c)
  {
    model = model + surface.values[c] * surface.values[c];
  }
  const Interval outer =
    std::isfinite(model.error) ? FromModel(model.TightRange()) : Interval(-kInfinity, kInfinity);
  std::array<double, 2> along{ 0.0, 0.0 };
  for (int i = 0; i <= ChebyshevModel::kDegree; ++i)
  {
    for (int j = 0; i + j <= ChebyshevModel::kDegree; ++j)
    {
      const double size = std::fabs(model.c[ChebyshevModel::Index(i, j)]);
      along[0] += size * i;
      along[1] += size * j;
    }
  }
  const auto width = [&](std::size_t k)
  { return box.upper[surface.axes[k]] - box.lower[surface.axes[k]]; };
  // Clips, poles and constants need both directions.
  const bool byWidth = !surface.clips.empty() || !outer.IsFinite() || along[0] == along[1];
  const bool second = byWidth ? width(1) > width(0) : along[1] > along[0];
  const int direction = surface.axes[second ? 1 : 0];
  Boxes.push_back({ box, outer, width(second ? 1 : 0) > kSmallestIntegralBox ? direction : -1 });
  if (outer.IsFinite())
  {
    TakeValues(surface, model);
  }
}

void SurfaceSearch::TakeValues(const SurfaceValues& surface, const ChebyshevModel& model)
{
  for (int k = 0; k < kPlacesAlong * kPlacesAlong; ++k)
  {
    const auto at = [](int i) { return 2.0 * i / (kPlacesAlong - 1) - 1.0; };
    const Line s = ChebyshevLine(at(k / kPlacesAlong));
    const Line t = ChebyshevLine(at(k % kPlacesAlong));
    const bool counts = std::ranges::all_of(
      surface.clips, [&](const ChebyshevModel& clip) { return ValueAt(clip, s, t).upper <= 0.0; });
    if (!counts)
    {
      continue;
    }
    const Interval value = FromModel(ValueAt(model, s, t));
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      eta[d] =
        std::clamp(ValueAt(surface.eta[static_cast<std::size_t>(d)], s, t).Middle(), -1.0, 1.0);
    }
    Low.Take({ value.upper, eta }, 0);
    High.Take({ -value.lower, eta }, 0);
  }
}
} // namespace pixelexact
