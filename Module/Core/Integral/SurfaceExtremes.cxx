// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/SurfaceExtremes.h"

#include "Core/Integral/CutParts.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/SurfaceSearch.h"
#include "Core/Location/Sample.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace pixelexact
{
namespace
{
/// Boxes of a part in the first round; each further round has eight times as many.
constexpr int kFirstExtremeBoxes = 32;
constexpr int kMoreExtremeBoxes = 8;

double ScalarAt(const IntegralQuestion& question, int component, int element, const Vec3& xi)
{
  std::vector<double> values(static_cast<std::size_t>(question.Components()));
  EvaluateAt(question.mesh, *question.field, element, std::span(&xi, 1), values, {});
  if (component != FieldFunction::kNorm)
  {
    return values[static_cast<std::size_t>(component)];
  }
  double norm = 0.0;
  for (const double value : values)
  {
    norm = std::hypot(norm, value);
  }
  return norm;
}

Extreme EndOf(const IntegralQuestion& question, int component,
  const std::vector<std::optional<SurfaceSearch>>& parts, const RangeEnd& end, double bound)
{
  Extreme extreme;
  if (end.part < 0)
  {
    return extreme;
  }
  extreme.element = parts[static_cast<std::size_t>(end.part)]->Element;
  extreme.xi = TensorToReference(question.mesh.ShapeOf(extreme.element), end.least.eta);
  MapForward(question.mesh, extreme.element, std::span(&extreme.xi, 1), std::span(&extreme.x, 1));
  extreme.value = ScalarAt(question, component, extreme.element, extreme.xi);
  // The value is rounded, the bound need not be.
  extreme.bound = end.sign * std::min(bound, end.sign * extreme.value);
  extreme.attained = end.sign * end.least.value;
  extreme.gap = std::max(rounding::Above(end.least.value - end.sign * extreme.bound), 0.0);
  return extreme;
}

/// Searches in all parts, given as elements and faces (-1: the cut).
SurfaceExtremes SearchParts(const IntegralQuestion& question, int component,
  const std::vector<ElementFace>& places, const RangeEffort& effort)
{
  std::vector<std::optional<SurfaceSearch>> parts(places.size());
  tbb::parallel_for(std::size_t{ 0 }, parts.size(),
    [&](std::size_t k)
    { parts[k].emplace(question, component, places[k].element, places[k].face); });
  SurfaceExtremes result;
  KnownRange known;
  std::vector<char> done(parts.size(), 0);
  for (int boxes = kFirstExtremeBoxes;; boxes *= kMoreExtremeBoxes)
  {
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      known.lower.Take(parts[k]->Lower().least, static_cast<int>(k));
      known.upper.Take(parts[k]->Upper().least, static_cast<int>(k));
    }
    if (boxes > effort.boxes || std::ranges::all_of(done, [](char one) { return one != 0; }))
    {
      break;
    }
    tbb::parallel_for(std::size_t{ 0 }, parts.size(),
      [&](std::size_t k) { done[k] = parts[k]->Refine(known, effort.tolerance, boxes) ? 1 : 0; });
  }
  Interval outer(kInfinity, -kInfinity);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    const SurfaceSearch& part = *parts[k];
    const Interval own = part.Outer();
    outer.lower = std::min(outer.lower, own.lower);
    outer.upper = std::max(outer.upper, own.upper);
    result.extremes.boxes += part.Looked();
    result.extremes.notFinite += part.IsFinite() ? 0 : 1;
    result.extremes.unbounded += part.IsEmpty() || own.IsFinite() ? 0 : 1;
    if (!part.IsEmpty())
    {
      ++(places[k].face < 0 ? result.elements : result.faces);
    }
  }
  result.extremes.minimum = EndOf(question, component, parts, known.lower, outer.lower);
  result.extremes.maximum = EndOf(question, component, parts, known.upper, -outer.upper);
  const double gap = known.Gap(effort.tolerance);
  result.extremes.met = result.extremes.minimum.gap <= gap && result.extremes.maximum.gap <= gap;
  return result;
}
} // namespace

void SurfaceExtremes::Add(const SurfaceExtremes& other)
{
  const auto take = [](Extreme& own, const Extreme& its, double sign)
  {
    if (its.element < 0)
    {
      return;
    }
    if (own.element < 0)
    {
      own = its;
      return;
    }
    const double bound = sign * std::min(sign * own.bound, sign * its.bound);
    own = sign * its.attained < sign * own.attained ? its : own;
    own.bound = bound;
    own.gap = std::max(rounding::Above(std::fabs(own.attained - bound)), 0.0);
  };
  take(extremes.minimum, other.extremes.minimum, 1.0);
  take(extremes.maximum, other.extremes.maximum, -1.0);
  extremes.notFinite = std::max(extremes.notFinite, other.extremes.notFinite);
  extremes.unbounded += other.extremes.unbounded;
  extremes.boxes += other.extremes.boxes;
  extremes.met = extremes.met && other.extremes.met;
  elements += other.elements;
  faces += other.faces;
  tooHigh = std::max(tooHigh, other.tooHigh);
  flat = std::max(flat, other.flat);
  isNumeric = isNumeric || other.isNumeric;
}

SurfaceExtremes FindExtremesOnCut(const IntegralQuestion& question, int component,
  const Locator& locator, const FaceTable& faces, const RangeEffort& effort)
{
  CheckSizes(question);
  const CutParts met = FindCutParts(question, locator, faces);
  std::vector<ElementFace> places;
  places.reserve(met.inside.size() + met.held.size() + met.unsure.size());
  for (const int element : met.inside)
  {
    places.push_back({ element, -1 });
  }
  for (const auto* const held : { &met.held, &met.unsure })
  {
    for (const SeenFace& face : *held)
    {
      places.push_back(face.face);
    }
  }
  SurfaceExtremes found = SearchParts(question, component, places, effort);
  found.extremes.notFinite += static_cast<int>(met.notFinite);
  found.tooHigh = met.tooHigh;
  found.flat = met.flat;
  found.isNumeric = IsNumeric(question);
  return found;
}

SurfaceExtremes FindExtremesOnFaces(const IntegralQuestion& question, int component,
  std::span<const ElementFace> faces, const RangeEffort& effort)
{
  CheckSizes(question);
  SurfaceExtremes found = SearchParts(question, component, { faces.begin(), faces.end() }, effort);
  found.isNumeric = IsNumeric(question);
  return found;
}
} // namespace pixelexact
