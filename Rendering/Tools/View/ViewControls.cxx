// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewControls.h"

#include "Base/Report.h"
#include "Scene/MeshSurfaceOptions.h"
#include "Scene/Model.h"

#include "Core/Base/Error.h"
#include "Trace/Appearance/FieldRange.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
constexpr const char* kTime = "--time-step";
constexpr const char* kIso = "--isosurface";
constexpr const char* kWarp = "--warp";
constexpr const char* kContours = "--contours";
constexpr int kMaxContours = 40;
/// Vectors with more components are listed by their magnitude alone.
constexpr int kMaxComponents = 3;

/// The proven range of the field of an iso-surface; the value alone where there is none.
std::array<double, 2> RangeOf(const IsoText& iso, const HighOrderModel& model)
{
  const std::array<double, 2> alone{ iso.value, iso.value };
  try
  {
    const IsoChoice choice = Resolve(iso, model);
    const Field& field =
      choice.field.empty() ? model.Fields().front() : model.GetField(choice.field);
    return FieldRange(model.GetMesh(), field, field.values.components == 1 ? 0 : choice.component)
      .value_or(alone);
  }
  catch (const Error& error)
  {
    Note(fmt::format("no slider for --isosurface: {}", error.what()));
    return alone;
  }
}
} // namespace

ViewControls::ViewControls(const ShownCommand& command)
{
  const Shot& shot = command.GetShot();
  for (const Field& field : shot.input.model->Fields())
  {
    Add(field);
  }
  const Field* shown = shot.scene.layers.front().field;
  if (shown != nullptr && std::ranges::find(Choices, shown->name, &Choice::field) == Choices.end())
  {
    Add(*shown);
  }
  Panel_.title = Choices.empty() ? "no field" : "field (f: next)";
  Panel_.text = "h: help";
  AddSliders(command);
  Show(command);
}

void ViewControls::Add(const Field& field)
{
  const int components = field.values.components;
  Choices.push_back({ field.name, {} });
  Panel_.fields.push_back(components > 1 ? "|" + field.name + "|" : field.name);
  for (int k = 0; k < components && components > 1 && components <= kMaxComponents; ++k)
  {
    Choices.push_back({ field.name, k });
    Panel_.fields.push_back(fmt::format("{} {}", field.name, k));
  }
}

void ViewControls::AddSliders(const ShownCommand& command)
{
  const Shot& shot = command.GetShot();
  const ShotOptions& options = command.Options().shot;
  if (const auto steps = static_cast<int>(shot.input.times.size()); steps > 1)
  {
    SliderValue slider = SliderOver(kTime, {}, { 0.0, steps - 1.0 }, shot.input.step);
    slider.step = 1.0;
    Panel_.sliders.push_back(slider);
  }
  if (!options.surfaces.IsoSurfaces().empty())
  {
    const IsoText& iso = options.surfaces.IsoSurfaces().front();
    SliderValue slider =
      SliderOver(kIso, iso.name + "=", RangeOf(iso, *shot.input.model), iso.value);
    slider.name = iso.name + " =";
    if (slider.low < slider.high)
    {
      Panel_.sliders.push_back(slider);
    }
  }
  if (options.input.warp)
  {
    const auto& [field, scale, direction] = *options.input.warp;
    const double end = scale == 0.0 ? 1.0 : 2.0 * scale;
    SliderValue slider =
      SliderOver(kWarp, field + "=", { std::min(0.0, end), std::max(0.0, end) }, scale);
    slider.name = "warp by " + field + " times";
    Panel_.sliders.push_back(slider);
  }
}

void ViewControls::Show(const ShownCommand& command)
{
  const Shot& shot = command.GetShot();
  const RenderOptions& options = command.Options();
  Panel_.field.reset();
  const Layer& first = shot.scene.layers.front();
  for (std::size_t row = 0; row < Choices.size() && first.field != nullptr; ++row)
  {
    const auto& [name, component] = Choices[row];
    const int whole = first.field->values.components == 1 ? 0 : kMagnitude;
    if (name == first.field->name && component.value_or(whole) == first.component)
    {
      Panel_.field = row;
    }
  }
  std::erase_if(
    Panel_.sliders, [](const SliderValue& slider) { return slider.option == kContours; });
  if (options.contours.AreGiven())
  {
    const auto count = static_cast<double>(options.contours.OfAll().Count());
    SliderValue slider = SliderOver(kContours, {}, { 1.0, kMaxContours }, count);
    slider.step = 1.0;
    slider.name = "contours";
    Panel_.sliders.push_back(slider);
  }
  for (SliderValue& slider : Panel_.sliders)
  {
    if (slider.option == kTime)
    {
      slider.value = shot.input.step;
      slider.name = "t = " + Short(TimeOf(shot.input)) + ", step";
    }
    else if (slider.option == kIso)
    {
      slider.value = options.shot.surfaces.IsoSurfaces().front().value;
    }
    else if (slider.option == kWarp)
    {
      slider.value = options.shot.input.warp->scale;
    }
  }
}

void ViewControls::ChooseField(std::size_t row, ShownState& state) const
{
  const Choice& choice = Choices[row];
  state.Set("--field", choice.field);
  state.Set("--component",
    choice.component ? std::optional(std::to_string(*choice.component)) : std::nullopt);
  state.ForgetRange();
}

std::optional<std::size_t> ViewControls::RowAfter(int rows) const
{
  if (Choices.empty())
  {
    return std::nullopt;
  }
  const auto count = static_cast<int>(Choices.size());
  const auto now = static_cast<int>(Panel_.field.value_or(0));
  return static_cast<std::size_t>((now + rows + count) % count);
}

void ViewControls::Apply(std::size_t slider, const Shot& shot, ShownState& state) const
{
  const SliderValue& value = Panel_.sliders[slider];
  if (value.option == kTime)
  {
    state.now.step = static_cast<int>(value.value);
    return;
  }
  state.Set(value.option, value.prefix + value.Text());
  const Field* shown = shot.scene.layers.front().field;
  const bool isOfShown = value.option == kIso && shown != nullptr &&
    (value.prefix == shown->name + "=" || value.prefix.starts_with(shown->name + "."));
  if (isOfShown)
  {
    // The surface has one value of its own field, and its colours would be those of another one.
    state.ForgetRange();
  }
}
} // namespace pixelexact
