// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Integral/SurfaceExtremes.h"

#include "Core/Integral/BoxRanges.h"
#include "Core/Integral/CutParts.h"
#include "Core/Integral/GraphIntegral.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Location/Sample.h"
#include "Core/Shape/ShapeFace.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pixelexact
{
namespace
{
/// Boxes of a part in the first round; each further round has eight times as many.
constexpr int kFirstExtremeBoxes = 32;
constexpr int kMoreExtremeBoxes = 8;
/// Values are taken at so many places along each variable of a parametrised surface.
constexpr int kPlacesAlong = 5;
/// Bounds the rounding of a model's value at a place, relative to its norm: 45 terms of Chebyshev
/// polynomials of degree 8.
constexpr double kPlaceRounding = 0x1p-44;
/// Gaps below this part of the largest magnitude are rounding.
constexpr double kMagnitudeGap = 0x1p-40;

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

/// A value that is proven to be attained, and its place in an element's eta, up to rounding. No
/// value is known where the interval is empty.
struct Attained
{
  double value = std::numeric_limits<double>::quiet_NaN();
  Vec3 eta{ 0.0 };
};

/// One end of the range of values: all numbers are multiplied by the sign, so that the least one is
/// searched.
struct RangeEnd
{
  double sign = 1.0;
  Attained least; ///< proven: a value not above it is attained
  int part = -1;

  [[nodiscard]] bool IsKnown() const { return !std::isnan(least.value); }
  bool Take(const Attained& other, int of)
  {
    if (std::isnan(other.value) || (IsKnown() && !(other.value < least.value)))
    {
      return false;
    }
    least = other;
    part = of;
    return true;
  }
};

/// The ends of all parts that are known at the beginning of a round.
struct KnownRange
{
  RangeEnd lower{ 1.0, {}, -1 };
  RangeEnd upper{ -1.0, {}, -1 };

  [[nodiscard]] double Gap(double tolerance) const
  {
    if (!lower.IsKnown() || !upper.IsKnown())
    {
      return 0.0;
    }
    const double low = lower.least.value;
    const double high = -upper.least.value;
    return std::max(tolerance * std::max(high - low, 0.0),
      kMagnitudeGap * std::max(std::fabs(low), std::fabs(high)));
  }
};

struct ExtremeBox
{
  PieceBox box;
  Interval outer; ///< holds the values on the surface in the box
  int direction = -1;
};

/// The search in one element, or on one of its faces.
class PartSearch
{
public:
  /// `face`: -1 for the cut.
  PartSearch(const IntegralQuestion& question, int component, int element, int face)
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

  [[nodiscard]] bool IsFinite() const { return Finite; }
  [[nodiscard]] bool IsEmpty() const { return Boxes.empty(); }
  [[nodiscard]] std::int64_t Looked() const { return Count; }
  [[nodiscard]] const RangeEnd& Lower() const { return Low; }
  [[nodiscard]] const RangeEnd& Upper() const { return High; }
  /// Holds all values; lower > upper where there is none.
  [[nodiscard]] Interval Outer() const
  {
    Interval all(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (const ExtremeBox& box : Boxes)
    {
      all.lower = std::min(all.lower, box.outer.lower);
      all.upper = std::max(all.upper, box.outer.upper);
    }
    return all;
  }

  /// Subdivides boxes that exceed the known range by more than the gap, the farthest first. Returns
  /// whether none is left.
  bool Refine(const KnownRange& known, double tolerance, int boxes)
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

  int Element;

private:
  void Look(ElementFunctions& functions, const PieceBox& box)
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

  /// The range of the scalar over all of a box.
  Interval RangeIn(ElementFunctions& functions, const PieceBox& box) const
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

  /// The scalar's own value from that of the model, which is a magnitude's square.
  [[nodiscard]] Interval FromModel(const Interval& value) const
  {
    return Component != FieldFunction::kNorm
      ? value
      : Sqrt(Interval(std::max(value.lower, 0.0), std::max(value.upper, 0.0)));
  }

  void LookAt(const SurfaceValues& surface, const PieceBox& box)
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

  /// Takes values at places of the surface that count.
  void TakeValues(const SurfaceValues& surface, const ChebyshevModel& model)
  {
    for (int k = 0; k < kPlacesAlong * kPlacesAlong; ++k)
    {
      const auto at = [](int i) { return 2.0 * i / (kPlacesAlong - 1) - 1.0; };
      const Line s = ChebyshevLine(at(k / kPlacesAlong));
      const Line t = ChebyshevLine(at(k % kPlacesAlong));
      const bool counts = std::ranges::all_of(surface.clips,
        [&](const ChebyshevModel& clip) { return ValueAt(clip, s, t).upper <= 0.0; });
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

  IntegralQuestion question_;
  int Component;
  int Face;
  double Tolerance = 0.0; ///< of the cut's polynomial
  bool Finite = true;
  std::vector<ExtremeBox> Boxes;
  std::int64_t Count = 0;
  RangeEnd Low{ 1.0, {}, -1 };
  RangeEnd High{ -1.0, {}, -1 };
};

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
  const std::vector<std::optional<PartSearch>>& parts, const RangeEnd& end, double bound)
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
  std::vector<std::optional<PartSearch>> parts(places.size());
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
    const PartSearch& part = *parts[k];
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
