// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FoundRanges.h"

#include "Base/Report.h"

#include "Core/Bounds/ElementBounds.h"
#include "Core/Element/OwnedExpansion.h"
#include "Formats/Slab.h"
#include "Trace/Appearance/FieldRange.h"
#include "Trace/Scene.h"

#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelexact
{
namespace
{
std::string RangeText(const FoundRange& range)
{
  if (!range)
  {
    return "not finite";
  }
  const auto [lower, upper] = *range;
  // Rounding is no value.
  const double least = 1e-12 * std::max(std::fabs(lower), std::fabs(upper));
  const auto text = [least](double value) { return Short(std::fabs(value) < least ? 0.0 : value); };
  return text(lower) + " to " + text(upper);
}

/// The lowest x[d] of all elements, or the highest (sign = -1). The boxes contain the elements.
double FindEnd(const Mesh& mesh, const std::vector<Box3>& boxes, int d, double sign)
{
  constexpr RangeEffort kEffort{ 1e-3, 200 };
  const auto least = [&](int e) { return sign > 0.0 ? boxes[e].lower[d] : -boxes[e].upper[d]; };
  const auto most = [&](int e) { return sign > 0.0 ? boxes[e].upper[d] : -boxes[e].lower[d]; };
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, least);
  double extent = 0.0;
  for (const int e : order)
  {
    extent = std::max(extent, most(e) - least(order.front()));
  }
  const Field coordinates{ {}, mesh.map };
  const RangeQuestion question{ Quantity::Component, &coordinates, d };
  double end = INFINITY;
  for (const int e : order)
  {
    if (least(e) >= end - kEffort.tolerance * extent)
    {
      break;
    }
    const Interval range = RangeOf(mesh, e, question, kEffort).attained;
    end = std::min(end,
      sign * (mesh.centre[3 * e + d] + mesh.size[e] * (sign > 0.0 ? range.lower : range.upper)));
  }
  return sign * end;
}

/// The maps of a surface in space without the solids beneath.
OwnedExpansion SurfacesOf(const Mesh& mesh)
{
  std::vector<Space> spaces;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    spaces.push_back(PlaneOf(mesh.map.SpaceOf(e)));
  }
  OwnedExpansion surfaces;
  surfaces.Allocate(spaces, 3);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    const Space& solid = mesh.map.SpaceOf(e);
    const std::span map(mesh.map.Coefficients(e), 3 * static_cast<std::size_t>(solid.Modes()));
    std::ranges::copy(
      SurfaceModes(solid, map), surfaces.Coefficients(static_cast<std::size_t>(e)).begin());
  }
  return surfaces;
}

nlohmann::ordered_json RangeToJson(const FoundRange& range)
{
  return range ? nlohmann::ordered_json(*range) : nlohmann::ordered_json();
}
} // namespace

FoundRanges FindRanges(const Mesh& mesh, const Field& field)
{
  FoundRanges ranges;
  for (int c = 0; c < field.values.components; ++c)
  {
    ranges.components.push_back(AttainedRange(mesh, field, c));
  }
  if (ranges.components.size() > 1)
  {
    ranges.magnitude = AttainedRange(mesh, field, kMagnitude);
  }
  return ranges;
}

std::array<double, 6> FindBounds(const Mesh& given)
{
  Mesh mesh = given;
  const OwnedExpansion surfaces = given.isShell ? SurfacesOf(given) : OwnedExpansion();
  if (given.isShell)
  {
    mesh.map = surfaces.View();
  }
  std::vector<Box3> boxes(static_cast<std::size_t>(mesh.Elements()));
  tbb::parallel_for(0, mesh.Elements(), [&](int e) { boxes[e] = MakeElementBox(mesh, e); });
  std::array<double, 6> bounds{};
  for (int d = 0; d < 3; ++d)
  {
    bounds[2 * d] = FindEnd(mesh, boxes, d, 1.0);
    bounds[2 * d + 1] = FindEnd(mesh, boxes, d, -1.0);
  }
  return bounds;
}

void AddTo(Table& table, const FoundRanges& ranges)
{
  if (ranges.components.size() == 1)
  {
    table.Row("", "  values {}", RangeText(ranges.components.front()));
    return;
  }
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < ranges.components.size(); ++c)
  {
    texts.push_back(fmt::format("component {} {}", c, RangeText(ranges.components[c])));
  }
  table.Row("", "  {}; magnitude {}", Listed(texts), RangeText(ranges.magnitude));
}

void AddTo(nlohmann::ordered_json& field, const FoundRanges& ranges)
{
  field["ranges"] = nlohmann::ordered_json::array();
  for (const FoundRange& range : ranges.components)
  {
    field["ranges"].push_back(RangeToJson(range));
  }
  if (ranges.components.size() > 1)
  {
    field["magnitude_range"] = RangeToJson(ranges.magnitude);
  }
}
} // namespace pixelexact
