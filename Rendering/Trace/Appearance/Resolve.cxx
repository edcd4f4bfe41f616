// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Appearance/Resolve.h"

#include "Core/Base/Error.h"
#include "Core/Contour/RoundValues.h"
#include "Core/Location/Locator.h"
#include "Trace/Appearance/FieldRange.h"
#include "Trace/View.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kAnyValue = -std::numeric_limits<double>::infinity();

/// Calls `visit` with the finite values above `lowest` of exact pixels on these layers.
template <class Visit>
void VisitValues(
  const Frame& frame, double lowest, const std::vector<bool>& layers, const Visit& visit)
{
  const auto add = [&](const SampleBuffers& sheet)
  {
    for (std::size_t i = 0; i < sheet.value.size(); ++i)
    {
      const double value = sheet.value[i];
      if (sheet.verdict[i] == kExactPixel && std::isfinite(value) && value > lowest &&
        (layers.empty() || layers[sheet.layer.empty() ? 0 : sheet.layer[i]]))
      {
        visit(value);
      }
    }
  };
  add(frame.centres);
  std::ranges::for_each(frame.centres.behind, add);
}

/// Interpolates linearly between the two values of the nearest ranks.
double Percentile(std::vector<double>& values, double percent)
{
  const double rank = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(rank));
  const auto at = values.begin() + below;
  std::nth_element(values.begin(), at, values.end());
  const double part = rank - static_cast<double>(below);
  return part > 0.0 ? std::lerp(*at, *std::min_element(at + 1, values.end()), part) : *at;
}

/// The percentiles of the values that the picture shows; none if it shows none.
ValueRange PercentileRange(const Frame& frame, double lowest, const std::vector<bool>& layers,
  const std::array<double, 2>& percents)
{
  std::vector<double> values;
  VisitValues(frame, lowest, layers, [&values](double value) { values.push_back(value); });
  return values.empty()
    ? std::nullopt
    : ValueRange({ Percentile(values, percents[0]), Percentile(values, percents[1]) });
}

std::array<double, 2> Symmetric(const std::array<double, 2>& range)
{
  const double most = std::max(std::fabs(range[0]), std::fabs(range[1]));
  return { -most, most };
}

double LowestOf(const LayerAppearance& layer)
{
  return layer.table != nullptr && layer.table->IsLogarithmic() ? 0.0 : kAnyValue;
}

/// The layers of a group that read its table.
std::vector<bool> GroupOf(const Appearance& appearance, std::size_t layer)
{
  std::vector<bool> group;
  for (const LayerAppearance& other : appearance.layers)
  {
    group.push_back(other.ReadsTable() && other.rangeGroup == appearance.layers[layer].rangeGroup);
  }
  return group;
}

/// The range for colours. Of several fields, the one with the largest rounding determines the
/// widening.
std::array<double, 2> Shown(
  const Scene& scene, const std::vector<bool>& group, const std::array<double, 2>& range)
{
  std::array<double, 2> shown = range;
  for (std::size_t k = 0; k < group.size(); ++k)
  {
    shown = group[k] ? BeyondRounding(*scene.layers[k].field, shown) : shown;
  }
  return shown;
}

/// The arguments of Resolve, and the steps that share them.
struct Resolver
{
  const Scene& scene;
  const Appearance& appearance;
  const Frame* frame;
  FieldRanges& fields;
  const std::vector<ValueRange>& ofAll;
  const std::function<void(double)>& progress;

  [[nodiscard]] ValueRange Seen(std::size_t layer, const std::vector<bool>& group) const
  {
    const RangeRule& rule = appearance.layers[layer].range;
    if (rule.of == RangeRule::Of::All && !ofAll.empty())
    {
      return ofAll[layer];
    }
    if (frame == nullptr)
    {
      return std::nullopt;
    }
    const double lowest = LowestOf(appearance.layers[layer]);
    return rule.of == RangeRule::Of::Parts ? PercentileRange(*frame, lowest, group, rule.ends)
                                           : ValuesSeen(*frame, lowest, group);
  }

  /// The range of all fields of the group; none if no field has a finite value.
  [[nodiscard]] ValueRange RangeOfFields(const std::vector<bool>& group) const
  {
    ValueRange sum;
    for (std::size_t k = 0; k < group.size(); ++k)
    {
      const Layer& layer = scene.layers[k];
      const ValueRange range = group[k]
        ? fields.Of(scene.locator->GetMesh(), *layer.field, layer.component, progress)
        : std::nullopt;
      if (range)
      {
        const std::array<double, 2> before = sum.value_or(*range);
        sum = { std::min(before[0], (*range)[0]), std::max(before[1], (*range)[1]) };
      }
    }
    return sum;
  }

  [[nodiscard]] std::array<double, 2> RangeOf(std::size_t layer) const
  {
    const LayerAppearance& asked = appearance.layers[layer];
    const RangeRule& rule = asked.range;
    if (rule.of == RangeRule::Of::Ends)
    {
      return rule.ends;
    }
    const std::vector<bool> group = GroupOf(appearance, layer);
    const bool ofField = rule.of == RangeRule::Of::Field;
    const ValueRange found = ofField ? RangeOfFields(group) : Seen(layer, group);
    if (!found)
    {
      return asked.table->RangeOfNothing();
    }
    const std::array<double, 2> shown = ofField ? *found : Shown(scene, group, *found);
    if (asked.table->IsLogarithmic() && !(shown[0] > 0.0))
    {
      return *found;
    }
    return rule.symmetric ? Symmetric(shown) : shown;
  }

  /// The range of the layer's colours in its table. A logarithmic table that cannot have `range`
  /// uses its RangeOfNothing.
  [[nodiscard]] std::array<double, 2> TableRange(
    std::size_t layer, const std::array<double, 2>& range) const
  {
    const ColorTable& table = *appearance.layers[layer].table;
    const bool refused = table.IsLogarithmic() && !(range[0] > 0.0);
    return refused ? table.RangeOfNothing() : range;
  }

  [[nodiscard]] ColorMap MapOver(std::size_t layer, const std::array<double, 2>& range) const
  {
    const LayerAppearance& asked = appearance.layers[layer];
    ColorMap map = asked.table->Over(range);
    return asked.bands == 0 ? map
                            : InBands(std::move(map), TableRange(layer, range), asked.bands,
                                asked.table->IsLogarithmic());
  }

  /// The values of a layer with a number of round contours.
  [[nodiscard]] std::vector<double> RoundContours(
    std::size_t layer, const std::array<double, 2>& range) const
  {
    const LayerAppearance& asked = appearance.layers[layer];
    const Field& field = *scene.layers[layer].field;
    std::vector<double> values =
      RoundValues(asked.contours.count, TableRange(layer, range), asked.table->IsLogarithmic());
    const ValueRange seen = ValuesSeen(*frame, layer);
    if (seen && IsOneValue(field, *seen))
    {
      const std::array<double, 2> wide = BeyondRounding(field, *seen);
      std::erase_if(values, [&wide](double value) { return value >= wide[0] && value <= wide[1]; });
    }
    return values;
  }

  [[nodiscard]] ResolvedLayer Of(std::size_t layer) const
  {
    const LayerAppearance& asked = appearance.layers[layer];
    const ContourRule& contours = asked.contours;
    if (contours.Any() && scene.layers[layer].field == nullptr)
    {
      throw Error("contours: the data have no field; set the number of contours to 0");
    }
    ResolvedLayer resolved;
    ColorMap byValue;
    if (asked.ReadsTable())
    {
      resolved.range = RangeOf(layer);
      byValue = MapOver(layer, *resolved.range);
    }
    resolved.map = asked.solid ? SolidColor(*asked.solid) : byValue;
    if (contours.count > 0 && frame != nullptr)
    {
      resolved.contours = RoundContours(layer, *resolved.range);
    }
    else
    {
      resolved.contours = contours.values;
    }
    std::vector<Rgba> colors = contours.colors;
    if (colors.size() > 1 && contours.count > 0)
    {
      colors.resize(resolved.contours.size());
    }
    resolved.contourColors = colors.empty() && byValue ? ColorsOf(resolved.contours, byValue)
                                                       : InOrderOf(resolved.contours, colors);
    return resolved;
  }
};
} // namespace

ValueRange FieldRanges::Of(
  const Mesh& mesh, const Field& field, int component, const std::function<void(double)>& progress)
{
  auto at = Known.find({ &field, component });
  if (at == Known.end())
  {
    const ValueRange range = FieldRange(mesh, field, component, progress);
    at = Known.emplace(std::pair(&field, component), range).first;
  }
  return at->second;
}

Buffer NeedsOfRules(const View& view)
{
  return !view.appearance.NeedsFrame() ? Buffer::None
                                       : Buffer::Value | Buffer::Verdict |
      (view.scene.layers.size() > 1 ? Buffer::Layer : Buffer::None);
}

ResolvedAppearance Resolve(const View& view, const Frame* frame, FieldRanges& fields,
  const std::vector<ValueRange>& ofAll, const std::function<void(double)>& progress)
{
  const Appearance& appearance = view.appearance;
  const Resolver resolver{ view.scene, appearance, frame, fields, ofAll, progress };
  ResolvedAppearance resolved;
  for (std::size_t k = 0; k < appearance.layers.size(); ++k)
  {
    resolved.layers.push_back(resolver.Of(k));
    const bool fewer = frame != nullptr &&
      resolved.layers.back().contours.size() < appearance.layers[k].contours.Count();
    resolved.ofOneValue = resolved.ofOneValue || fewer;
  }
  return resolved;
}

ValueRange ValuesSeen(const Frame& frame, double lowest, const std::vector<bool>& layers)
{
  ValueRange range;
  VisitValues(frame, lowest, layers,
    [&range](double value)
    {
      range = range ? std::array{ std::min((*range)[0], value), std::max((*range)[1], value) }
                    : std::array{ value, value };
    });
  return range;
}

ValueRange ValuesSeen(const Frame& frame, std::size_t layer)
{
  std::vector<bool> layers(layer + 1, false);
  layers.back() = true;
  layers.resize(Scene::kMaxLayers + 1, false);
  return ValuesSeen(frame, kAnyValue, layers);
}

ValueRange RangeSeen(const View& view, const Frame& frame, std::size_t layer)
{
  const std::vector<bool> group = GroupOf(view.appearance, layer);
  const ValueRange seen = ValuesSeen(frame, LowestOf(view.appearance.layers[layer]), group);
  return seen ? ValueRange(Shown(view.scene, group, *seen)) : seen;
}
} // namespace pixelexact
