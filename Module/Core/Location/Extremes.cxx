// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Extremes.h"

#include "Core/Location/Sample.h"
#include "Core/Math/Interval.h"
#include "Core/Shape/ShapeFace.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace pixelexact
{
namespace
{
/// The quantity at a point, as EvaluateAt computes the field.
double ValueAt(const Mesh& mesh, const RangeQuestion& question, int element, const Vec3& xi)
{
  std::vector<double> values(static_cast<std::size_t>(question.field->values.components));
  EvaluateAt(mesh, *question.field, element, std::span(&xi, 1), values, {});
  if (question.quantity == Quantity::Component)
  {
    return values[static_cast<std::size_t>(question.component)];
  }
  double norm = 0.0;
  for (const double value : values)
  {
    norm = std::hypot(norm, value);
  }
  return norm;
}

/// The extreme at a point of eta. `sign`: 1 of a minimum, -1 of a maximum; `bound` and `attained`
/// are multiplied by it.
Extreme ExtremeAt(const Mesh& mesh, const RangeQuestion& question, int element, const Vec3& eta,
  double sign, double bound, double attained)
{
  Extreme extreme;
  extreme.element = element;
  extreme.xi = TensorToReference(mesh.ShapeOf(element), eta);
  MapForward(mesh, element, std::span(&extreme.xi, 1), std::span(&extreme.x, 1));
  extreme.value = ValueAt(mesh, question, element, extreme.xi);
  // The value is rounded, the bound need not be.
  extreme.bound = sign * std::min(bound, sign * extreme.value);
  extreme.attained = sign * attained;
  extreme.gap = std::max(rounding::Above(attained - sign * extreme.bound), 0.0);
  return extreme;
}
} // namespace

Extremes FindExtremes(const Mesh& mesh, const RangeQuestion& question, bool isPlane,
  const RangeEffort& effort, const RangeProgress& progress)
{
  const MeshRange found = RangeOf(mesh, question, effort, progress);
  Extremes extremes;
  extremes.notFinite = found.notFinite;
  extremes.unbounded = found.unbounded;
  extremes.met = found.range.met;
  extremes.boxes = found.boxes;
  const auto placeOf = [&](int element, Vec3 eta)
  {
    if (mesh.isShell)
    {
      const Shape shape = mesh.ShapeOf(element);
      const ShapeFace face = FacesOf(shape)[static_cast<std::size_t>(ShellFace(shape))];
      eta[face.direction] = face.upper ? 1.0 : -1.0;
    }
    else if (isPlane)
    {
      eta[AcrossSlab(mesh.ShapeOf(element))] = 0.0;
    }
    return eta;
  };
  if (const int e = found.lowerElement; e >= 0)
  {
    extremes.minimum = ExtremeAt(mesh, question, e, placeOf(e, found.lowerPoint), 1.0,
      found.range.outer.lower, found.range.attained.lower);
  }
  if (const int e = found.upperElement; e >= 0)
  {
    extremes.maximum = ExtremeAt(mesh, question, e, placeOf(e, found.upperPoint), -1.0,
      -found.range.outer.upper, -found.range.attained.upper);
  }
  return extremes;
}
} // namespace pixelexact
