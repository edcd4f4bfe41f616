// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Looks.h"

#include "Base/Report.h"
#include "Scene/ColorOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Core/Faces/FaceTable.h"
#include "HighOrderModel.h"
#include "Views/VtkLook.h"

#include <optional>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// Where nothing else is said, of layers without a field.
constexpr std::array<double, 3> kNoField{ 0.6, 0.7, 0.8 };

/// The colour in the place of the map's; none: by value.
std::optional<std::array<double, 3>> SolidOf(
  const ColorOptions& colors, const Layer& layer, const LayerSettings& settings)
{
  if (settings.color)
  {
    return settings.color;
  }
  // A layer that asks for a map has one.
  if (colors.Solid() && !settings.colormap && !settings.range)
  {
    return colors.Solid();
  }
  return layer.field == nullptr ? std::optional(kNoField) : std::nullopt;
}

bool IsLit(const Shot& shot, std::size_t layer)
{
  const bool unasked = !shot.scene.layers[layer].surface->IsFlat() && shot.lights != Lit::Off;
  return shot.settings[layer].lights.value_or(unasked || shot.lights == Lit::On);
}

/// The command line's colours over any range.
class OptionTable final : public ColorTable
{
public:
  OptionTable(const ColorOptions& colors, std::optional<std::string> map)
    : Colors(colors)
    , Map(std::move(map))
  {
  }

  [[nodiscard]] ColorMap Over(const std::array<double, 2>& range) const override
  {
    if (IsLogarithmic() && !(range[0] > 0.0))
    {
      throw Error("--log needs values above 0, and the range found begins at " + Short(range[0]) +
        "; choose --range cut or --range a,b");
    }
    return Colors.MapOver(range, Map);
  }
  [[nodiscard]] bool IsLogarithmic() const override { return Colors.Logarithm(); }
  [[nodiscard]] std::array<double, 2> RangeOfNothing() const override
  {
    return IsLogarithmic() ? std::array{ 1.0, 10.0 } : std::array{ 0.0, 1.0 };
  }
  [[nodiscard]] bool IsSame(const ColorTable& other) const override
  {
    const auto* table = dynamic_cast<const OptionTable*>(&other);
    return table != nullptr && &table->Colors == &Colors && table->Map == Map;
  }

private:
  const ColorOptions& Colors;
  std::optional<std::string> Map;
};

/// The first layer that shows the same values in a range that is found, too; its own number where
/// the range is given.
std::size_t GroupOf(const ViewLook& look, const Shot& shot, std::size_t layer)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  const auto isFound = [&look](std::size_t k)
  { return look.layers[k].range.of != RangeRule::Of::Ends; };
  for (std::size_t k = 0; k < layer && isFound(layer); ++k)
  {
    if (isFound(k) && layers[k].field == layers[layer].field &&
      layers[k].component == layers[layer].component)
    {
      return k;
    }
  }
  return layer;
}

ContourRule ContoursOf(const ContourOptions* contours, const LayerSettings& settings)
{
  if (contours == nullptr || !contours->AreGiven())
  {
    return {};
  }
  ContourRule rule = settings.contours.value_or(contours->OfAll());
  rule.colors = contours->Colors();
  return rule;
}

LayerLook LookOfLayer(
  const ColorOptions& colors, const ContourOptions* contours, const Shot& shot, std::size_t layer)
{
  const LayerSettings& settings = shot.settings[layer];
  LayerLook look;
  if (shot.scene.layers[layer].field != nullptr)
  {
    look.table = std::make_shared<OptionTable>(colors, settings.colormap);
  }
  look.range = settings.range.value_or(colors.Range());
  if (const auto solid = SolidOf(colors, shot.scene.layers[layer], settings))
  {
    look.solid = ToRgba(solid->data());
  }
  look.opacity = settings.opacity;
  if (IsLit(shot, layer))
  {
    look.material.emplace();
  }
  look.contours = ContoursOf(contours, settings);
  return look;
}
} // namespace

ViewLook LookOf(const ColorOptions& colors, const ContourOptions* contours, const Shot& shot)
{
  ViewLook look;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    look.layers.push_back(LookOfLayer(colors, contours, shot, k));
    look.layers.back().rangeGroup = GroupOf(look, shot, k);
  }
  // A light at the eye, as a new vtkRenderer has.
  look.lights = { Light{ .headlight = true } };
  look.lit.eye = shot.view.position;
  look.lit.direction = shot.MakeCamera().ViewDirection();
  look.lit.parallel = shot.view.parallel;
  look.samples = shot.samples;
  look.edges = shot.edges;
  look.faces = shot.edges && shot.edgesByKind ? &shot.input.model->Faces() : nullptr;
  if (shot.outlines)
  {
    look.outlines = ToRgba(shot.outlines->data());
  }
  if (look.HasContours())
  {
    look.contours = contours->Look(colors.BackgroundColor());
  }
  return look;
}

Looks::Looks(const ColorOptions& colors, const ContourOptions* contours, const Shot& shot,
  const Frame& frame, std::shared_ptr<ContourBounds> bounds)
  : TheLook(LookOf(colors, contours, shot))
{
  FieldRanges fields;
  ProgressLine line("bounding");
  TheResolved = Resolve(
    TheLook, shot.scene, &frame, fields, shot.valuesOfAll, [&line](double part) { line(part); });
  for (std::size_t k = 0; k < TheLook.layers.size(); ++k)
  {
    const ResolvedLayer& layer = TheResolved.layers[k];
    TheRanges.push_back(TheLook.layers[k].solid ? std::nullopt : layer.range);
    TheMaps.push_back(layer.map);
  }
  Paints = std::make_unique<Painter>(TheLook, shot.scene, TheResolved, std::move(bounds));
}
} // namespace pixelexact
