// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LayerOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Scene/ColorOptions.h"

#include "Trace/Scene.h"

#include "Core/Base/Counted.h"

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr const char* kLayerForm = "N:KEY=VALUE,...";

[[noreturn]] void Complain(const std::string& text, const std::string& what)
{
  throw UsageError("--layer: '" + text + "': " + what);
}

template <std::size_t Count>
std::array<double, Count> Numbers(const std::string& value, const char* form)
{
  std::array<double, Count> numbers{};
  const std::vector<std::string> parts = SplitAt(value, ':');
  for (std::size_t i = 0; i < Count; ++i)
  {
    if (parts.size() != Count || !ParseNumber(parts[i], numbers[i]) || !std::isfinite(numbers[i]))
    {
      Complain(value, std::string("expected ") + form);
    }
  }
  return numbers;
}

std::array<double, 3> Color(const std::string& value)
{
  const auto color = Numbers<3>(value, "red:green:blue, 0 to 1 each");
  CheckColor("--layer", { color.begin(), color.end() });
  return color;
}

double Opacity(const std::string& value)
{
  const double opacity = Numbers<1>(value, "an opacity from 0 to 1")[0];
  if (opacity < 0.0 || opacity > 1.0)
  {
    Complain(value, "an opacity is from 0 to 1");
  }
  return opacity;
}

/// Returns whether a value is `first`; throws where it is neither of the two words.
bool IsFirst(const std::string& value, const char* first, const char* second)
{
  if (value != first && value != second)
  {
    Complain(value, std::string("expected ") + first + " or " + second);
  }
  return value == first;
}

using Setter = std::function<void(LayerSettings& layer, const std::string& value)>;
const std::map<std::string, Setter>& Setters()
{
  static const std::map<std::string, Setter> kSetters{
    { "field", [](LayerSettings& layer, const std::string& value) { layer.field = value; } },
    { "component",
      [](LayerSettings& layer, const std::string& value)
      {
        layer.component = ParseComponent(value);
        if (!layer.component)
        {
          Complain(value, "expected 'magnitude', x, y, z or a number from 0");
        }
      } },
    { "precision",
      [](LayerSettings& layer, const std::string& value) {
        layer.precision = IsFirst(value, "float", "double") ? Precision::Float : Precision::Double;
      } },
    { "opacity",
      [](LayerSettings& layer, const std::string& value) { layer.opacity = Opacity(value); } },
    { "colormap",
      [](LayerSettings& layer, const std::string& value)
      {
        CheckMap("--layer", value);
        layer.colormap = value;
      } },
    { "range",
      [](LayerSettings& layer, const std::string& value)
      { layer.range = ReadRange("--layer: range", value, ':'); } },
    { "color", [](LayerSettings& layer, const std::string& value) { layer.color = Color(value); } },
    { "contours",
      [](LayerSettings& layer, const std::string& value)
      {
        layer.contours =
          value == "off" ? ContourRule{} : ReadContours("--layer: contours", value, ':');
      } },
    { "lights",
      [](LayerSettings& layer, const std::string& value)
      { layer.lights = IsFirst(value, "on", "off"); } },
  };
  return kSetters;
}

/// Splits a text at the commas outside of brackets and quotes, which expressions have; blanks
/// before a setting are left out.
std::vector<std::string> SplitSettings(const std::string& text)
{
  std::vector<std::string> settings(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text)
  {
    if (quote != 0 || c == '"' || c == '\'')
    {
      quote = quote == 0 ? c : (quote == c ? 0 : quote);
    }
    depth += c == '(' || c == '[' ? 1 : 0;
    depth -= c == ')' || c == ']' ? 1 : 0;
    if (c == ',' && depth <= 0 && quote == 0)
    {
      settings.emplace_back();
    }
    else if (c != ' ' || !settings.back().empty())
    {
      settings.back() += c;
    }
  }
  return settings;
}

/// The settings that were given, by surface.
using Given = std::set<std::pair<int, std::string>>;

void Read(const std::string& text, std::vector<LayerSettings>& layers, Given& given)
{
  const auto colon = text.find(':');
  int number = 0;
  if (colon == std::string::npos || !ParseInteger(text.substr(0, colon), number))
  {
    Complain(text, std::string("expected ") + kLayerForm);
  }
  if (number < 1 || static_cast<std::size_t>(number) > layers.size())
  {
    Complain(text,
      "the number is of " + Counted(layers.size(), "surface") +
        ", counted from 1 in the order of " + "their kinds in the help");
  }
  for (const std::string& setting : SplitSettings(text.substr(colon + 1)))
  {
    const auto equal = setting.find('=');
    const auto setter = Setters().find(setting.substr(0, equal));
    if (equal == std::string::npos || setter == Setters().end())
    {
      std::vector<std::string> names;
      for (const auto& [name, set] : Setters())
      {
        names.push_back(name);
      }
      Complain(text, "'" + setting + "' is none of " + Listed(names) + ", each with =VALUE");
    }
    if (!given.emplace(number, setter->first).second)
    {
      Complain(text,
        "surface " + std::to_string(number) + " has its " + setter->first +
          " already; give it once");
    }
    setter->second(layers[static_cast<std::size_t>(number) - 1], setting.substr(equal + 1));
  }
}
} // namespace

std::optional<int> ParseComponent(const std::string& text)
{
  if (text == "magnitude")
  {
    return kMagnitude;
  }
  if (text == "x" || text == "y" || text == "z")
  {
    return text.front() - 'x';
  }
  int component = 0;
  return ParseInteger(text, component) && component >= 0 ? std::optional(component) : std::nullopt;
}

void LayerOptions::AddTo(CLI::App& command)
{
  Bind(command, "--layer", [this](const std::string& text) { Texts.push_back(text); });
}

std::vector<LayerSettings> LayerOptions::Make(std::size_t surfaces) const
{
  std::vector<LayerSettings> layers(surfaces);
  Given given;
  for (const std::string& text : Texts)
  {
    Read(text, layers, given);
  }
  for (const LayerSettings& layer : layers)
  {
    if (layer.color && (layer.colormap || layer.range))
    {
      throw UsageError(
        "--layer: color takes the place of colormap and range; leave one of them out");
    }
  }
  return layers;
}
} // namespace pixelexact
