// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ShotAppearance.h"

#include "Base/Report.h"
#include "Scene/ColorOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "Views/VtkLook.h"

#include <optional>
#include <string>
#include <utility>

namespace pixelexact
{
namespace
{
/// Parts that face the viewer, where the light is, have exactly the colours of the map, and parts
/// that are seen from their edge 0.4 of them.
constexpr Material kMaterial{ .ambient = 0.4, .diffuse = 0.6 };

/// Default colour of layers without a field.
constexpr std::array<double, 3> kNoField{ 0.6, 0.7, 0.8 };

/// The colour in the place of the map's; none: by value.
std::optional<std::array<double, 3>> SolidOf(
  const ColorOptions& colors, const Layer& layer, const LayerSettings& settings)
{
  if (settings.color)
  {
    return settings.color;
  }
  // A layer with an explicit map uses it.
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
  OptionTable(const ColorOptions& colors, std::optional<std::string> map, std::string field)
    : Colors(colors)
    , Map(std::move(map))
    , Field(std::move(field))
  {
  }

  [[nodiscard]] ColorMap Over(const std::array<double, 2>& range) const override
  {
    if (IsLogarithmic() && !(range[0] > 0.0))
    {
      throw Error("--range field: field '" + Field + "' is only proven to be above " +
        Short(range[0]) + ", and --log needs values above 0; choose --range cut or --range a,b");
    }
    return Colors.MapOver(range, Map);
  }
  [[nodiscard]] bool IsLogarithmic() const override { return Colors.Logarithm(); }
  [[nodiscard]] bool IsOpaque() const override { return true; }
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
  std::string Field; ///< its name, for messages
};

/// The first layer with the same values whose range is also computed; the layer's own number where
/// its range is given.
std::size_t GroupOf(const Appearance& appearance, const Shot& shot, std::size_t layer)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  const auto isFound = [&appearance](std::size_t k)
  { return appearance.layers[k].range.of != RangeRule::Of::Ends; };
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

LayerAppearance AppearanceOfLayer(
  const ColorOptions& colors, const ContourOptions* contours, const Shot& shot, std::size_t layer)
{
  const LayerSettings& settings = shot.settings[layer];
  LayerAppearance appearance;
  if (const Field* field = shot.scene.layers[layer].field)
  {
    appearance.table = std::make_shared<OptionTable>(colors, settings.colormap, field->name);
  }
  appearance.bands = colors.Bands().value_or(0);
  appearance.range = settings.range.value_or(colors.Range());
  if (const auto solid = SolidOf(colors, shot.scene.layers[layer], settings))
  {
    appearance.solid = ToRgba(solid->data());
  }
  appearance.opacity = settings.opacity;
  if (IsLit(shot, layer))
  {
    appearance.material = kMaterial;
  }
  appearance.contours = ContoursOf(contours, settings);
  return appearance;
}
} // namespace

View ViewOf(const ColorOptions& colors, const ContourOptions* contours, const Shot& shot)
{
  View view{ shot.input.model, shot.scene, { shot.view, shot.size.width, shot.size.height },
    shot.appearance, 1, shot.volume };
  Appearance& appearance = view.appearance;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    appearance.layers.push_back(AppearanceOfLayer(colors, contours, shot, k));
    appearance.layers.back().rangeGroup = GroupOf(appearance, shot, k);
  }
  // A light at the eye, as a new vtkRenderer has.
  appearance.lights = { Light{ .headlight = true } };
  appearance.lit.eye = shot.view.position;
  appearance.lit.direction = shot.MakeCamera().ViewDirection();
  appearance.lit.parallel = shot.view.parallel;
  appearance.undecided = colors.Undecided();
  if (appearance.HasContours())
  {
    appearance.contours = contours->MakeAppearance(colors.BackgroundColor());
  }
  SetTranslucency(view);
  return view;
}

ShotAppearance::ShotAppearance(const ColorOptions& colors, const ContourOptions* contours,
  const Shot& shot, const Frame& frame, std::shared_ptr<ContourBounds> bounds)
  : Of(ViewOf(colors, contours, shot))
{
  FieldRanges fields;
  ProgressLine line("bounding");
  resolved_ = Resolve(Of, &frame, fields, shot.valuesOfAll, [&line](double part) { line(part); });
  for (std::size_t k = 0; k < Of.appearance.layers.size(); ++k)
  {
    const ResolvedLayer& layer = resolved_.layers[k];
    ranges_.push_back(Of.appearance.layers[k].solid ? std::nullopt : layer.range);
    maps_.push_back(layer.map);
  }
  Paints = std::make_unique<Painter>(Of, resolved_, std::move(bounds));
}
} // namespace pixelexact
