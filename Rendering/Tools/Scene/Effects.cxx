// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Effects.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Scene/LayerOptions.h"

#include "Core/Base/Error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace pixelexact
{
namespace
{
// Options of colours by value.
constexpr std::array kOfMaps{ "--range", "--colormap", "--log", "--nan-color", "--bands" };

using Layers = std::vector<LayerSettings>;

/// The first of these options in the command line; empty where there is none.
template <class Names>
std::string FirstGiven(const CLI::App& command, const Names& names)
{
  const auto given =
    std::ranges::find_if(names, [&command](const char* name) { return IsGiven(command, name); });
  return given == std::end(names) ? std::string() : std::string(*given);
}

/// Refuses enclosures in single precision: they enclose values in double precision.
void CheckPrecision(const CLI::App& command, const Layers& layers)
{
  const std::string bounds = FirstGiven(command, std::array{ "--enclosures", "--show-undecided" });
  const bool floats = IsGiven(command, "--precision") &&
    command.get_option("--precision")->as<std::string>() == "float";
  const auto isFloat = [floats](const LayerSettings& layer)
  { return layer.precision ? *layer.precision == Precision::Float : floats; };
  if (!bounds.empty() && std::ranges::any_of(layers, isFloat))
  {
    throw UsageError(bounds + ": values in single precision have no enclosures; leave out " +
      (floats ? "--precision float" : "the layer's precision=float"));
  }
}

bool HasMap(const LayerSettings& layer)
{
  return layer.range || layer.colormap;
}
} // namespace

void CheckEffects(const CLI::App& command, const Layers& layers)
{
  const auto check = [&](const char* option, const char* why, const auto& overrides)
  {
    if (IsGiven(command, option) && std::ranges::all_of(layers, overrides))
    {
      throw UsageError(std::string(option) + " has no effect: every surface has " + why +
        " of its own; leave one of them out");
    }
  };
  check("--component", "a field or a component",
    [](const LayerSettings& layer) { return layer.field || layer.component; });
  check("--precision", "a precision",
    [](const LayerSettings& layer) { return layer.precision.has_value(); });
  check("--lights", "lights", [](const LayerSettings& layer) { return layer.lights.has_value(); });
  check("--color", "colours",
    [](const LayerSettings& layer) { return layer.color.has_value() || HasMap(layer); });
  check("--range", "colours",
    [](const LayerSettings& layer) { return layer.color.has_value() || layer.range.has_value(); });
  check("--colormap", "colours",
    [](const LayerSettings& layer)
    { return layer.color.has_value() || layer.colormap.has_value(); });
  for (const char* option : { "--log", "--nan-color", "--bands" })
  {
    check(option, "a colour", [](const LayerSettings& layer) { return layer.color.has_value(); });
  }
  CheckPrecision(command, layers);
  const auto hasContours = [](const LayerSettings& layer) { return layer.contours.has_value(); };
  check("--contours", "contours", hasContours);
  if (!IsGiven(command, "--contours") && std::ranges::any_of(layers, hasContours))
  {
    throw UsageError("--layer: contours need --contours, those of all other surfaces; give them");
  }
  const bool solid = IsGiven(command, "--color");
  check("--show-undecided", "a colour",
    [solid](const LayerSettings& layer) { return layer.color || (solid && !HasMap(layer)); });
}

void CheckEffectsBeside(const std::string& option, const CLI::App& command, const Layers& layers)
{
  std::string idle = FirstGiven(command, kOfMaps);
  idle =
    idle.empty() ? FirstGiven(command, std::array{ "--color", "--lights", "--contours" }) : idle;
  const bool layered = std::ranges::any_of(layers,
    [](const LayerSettings& layer)
    { return HasMap(layer) || layer.color || layer.lights || layer.opacity < 1.0; });
  if (idle.empty() && layered)
  {
    idle = "--layer with colours, lights or an opacity";
  }
  if (!idle.empty())
  {
    throw UsageError(
      idle + " has no effect: " + option + " paints a legend's colours; leave one of them out");
  }
}

void CheckEffectsWithoutColors(
  const ContourOptions& contours, const CLI::App& command, const Layers& layers)
{
  const bool maps = contours.ByMap();
  const auto readsRange = [&](const LayerSettings& layer)
  { return maps || layer.contours.value_or(contours.OfAll()).count > 0; };
  std::string idle = FirstGiven(
    command, std::array{ "--color", "--lights", "--nan-color", "--show-undecided", "--samples" });
  if (idle.empty() && !maps)
  {
    idle = FirstGiven(command, std::array{ "--colormap", "--bands" });
  }
  if (idle.empty() && std::ranges::none_of(layers, readsRange))
  {
    idle = FirstGiven(command, std::array{ "--range", "--log" });
  }
  const bool layered = std::ranges::any_of(layers,
    [&](const LayerSettings& layer)
    {
      return layer.color || layer.lights || layer.opacity < 1.0 || (layer.colormap && !maps) ||
        (layer.range && !readsRange(layer));
    });
  if (idle.empty() && layered)
  {
    idle = "--layer with colours, lights or an opacity";
  }
  if (!idle.empty())
  {
    throw UsageError(
      idle + " has no effect: --contours-only shows no colours of surfaces; leave one of them out");
  }
}

void CheckEffectsWithoutField(const CLI::App& command, const Layers& layers)
{
  std::string idle = FirstGiven(command, kOfMaps);
  idle = idle.empty() ? FirstGiven(command,
                          std::array{ "--field", "--component", "--precision", "--enclosures",
                            "--show-undecided", "--contours" })
                      : idle;
  const bool layered = std::ranges::any_of(layers,
    [](const LayerSettings& layer)
    { return HasMap(layer) || layer.field || layer.component || layer.precision; });
  if (idle.empty() && layered)
  {
    idle = "--layer with a field or its colours";
  }
  if (IsGiven(command, "--show") && command.get_option("--show")->as<std::string>() == "jumps")
  {
    idle = "--show jumps";
  }
  if (!idle.empty())
  {
    throw Error(idle + ": the input has no field; leave it out, or name the file of a field");
  }
}
} // namespace pixelexact
