// SPDX-License-Identifier: BSD-3-Clause
#include "Serve/PageWords.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Base/Settings.h"
#include "Picture/ShownWords.h"

#include "Views/VtkColorMap.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace pixelexact
{
namespace
{
/// Options that a page may change.
constexpr std::array<std::string_view, 38> kChangeable{ "--field", "--component", "--time-step",
  "--phase", "--warp", "--warp-direction", "--plane", "--isosurface", "--boundary", "--clip",
  "--range", "--colormap", "--bands", "--log", "--nan-color", "--color", "--background", "--lights",
  "--samples", "--edges", "--edge-color", "--edges-by-kind", "--outlines", "--outline-color",
  "--contours", "--contour-width", "--contour-color", "--contours-only", "--contour-labels",
  "--show-undecided-contours", "--owners", "--show", "--show-undecided", "--mesh-outline",
  "--figure", "--title", "--precision", "--truncate-order" };

/// Options of the server, and of files and reports that render writes.
constexpr std::array<std::string_view, 13> kNotOfPicture{ "--address", "--port", "--views",
  "--until-input-ends", "--output", "--buffers", "--arrays", "--contours-output",
  "--contours-tolerance", "--json", "--quiet", "--jpeg-quality", "--threads" };

/// Options of figures and animations, beside those that need --figure.
constexpr std::array<std::string_view, 3> kOfFigure{ "--figure", "--dpi", "--fps" };

/// More samples of a pixel take the server long.
constexpr int kMaxSamples = 8;
constexpr std::size_t kMaxValue = 4000;

bool Contains(auto const& names, std::string_view name)
{
  return std::ranges::find(names, name) != names.end();
}

/// Whether an option gives a surface or belongs to one, so that another surface replaces it.
bool IsOfSurface(std::string_view option)
{
  const Setting* const row = FindSetting("serve", option);
  return row != nullptr && row->group == FindSetting("serve", "--plane")->group &&
    option != "--clip";
}

std::vector<std::string> Without(const std::vector<std::string>& words, auto const& isRemoved)
{
  std::vector<std::string> kept;
  std::ranges::copy_if(
    words, std::back_inserter(kept), [&](const std::string& word) { return !isRemoved(word); });
  return kept;
}

void CheckValue(const std::string& option, const std::string& value)
{
  const bool hasControl =
    std::ranges::any_of(value, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (value.empty() || value.size() > kMaxValue || hasControl)
  {
    throw UsageError(option + ": the value is empty, too long or has control characters");
  }
  if (option == "--colormap" && !HasColorMap(value))
  {
    throw UsageError("--colormap: a page chooses one of " + Listed(ColorMapNames()) +
      ", each reversed with _r after its name; files are given to serve");
  }
  if (option == "--time-step" && value == "all")
  {
    throw UsageError("--time-step: a page shows one step");
  }
  if (int samples = 0;
      option == "--samples" && ParseInteger(value, samples) && samples > kMaxSamples)
  {
    throw UsageError("--samples: a page has at most " + std::to_string(kMaxSamples));
  }
}
} // namespace

std::vector<std::string> WordsOfPicture(const std::vector<std::string>& words)
{
  return Without(
    words, [](const std::string& word) { return Contains(kNotOfPicture, OptionOf(word)); });
}

std::vector<std::string> WithoutFigure(const std::vector<std::string>& words)
{
  return Without(words,
    [](const std::string& word)
    {
      const std::string option = OptionOf(word);
      const Setting* const row = FindSetting("serve", option);
      return Contains(kOfFigure, option) || (row != nullptr && row->needs == "--figure");
    });
}

std::vector<std::string> WithOption(const std::vector<std::string>& words,
  const std::string& option, const std::optional<std::string>& value)
{
  const Setting* row = FindSetting("serve", option);
  if (row == nullptr || !Contains(kChangeable, option))
  {
    throw UsageError("'" + option + "': a page cannot change this option");
  }
  std::string word = option;
  if (value)
  {
    CheckValue(option, *value);
    const bool isAlone =
      row->type == SettingType::Flag || (row->type == SettingType::NumberIfAny && *value == "true");
    word += isAlone ? "" : "=" + *value;
  }
  std::vector<std::string> changed = words;
  const auto first = std::ranges::find(changed, option, OptionOf);
  const bool isSurface = IsOfSurface(option);
  if (value && first != changed.end())
  {
    *first = word;
  }
  else if (first != changed.end() && !isSurface)
  {
    changed.erase(first);
  }
  else if (value)
  {
    if (isSurface)
    {
      changed = Without(changed, [](const std::string& old) { return IsOfSurface(OptionOf(old)); });
    }
    changed.insert(std::ranges::find(changed, "--"), word);
  }
  // A step by its number replaces one by its time.
  return option == "--time-step"
    ? Without(changed, [](const std::string& old) { return OptionOf(old) == "--time"; })
    : changed;
}

nlohmann::ordered_json OptionsOf(const std::vector<std::string>& words)
{
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  for (const std::string& word : words)
  {
    const std::string name = OptionOf(word);
    // Names of files do not leave the server; the command line states them where it is wanted.
    if (name.empty() || options.contains(name) || !Contains(kChangeable, name))
    {
      continue;
    }
    if (word.size() > name.size())
    {
      options[name] = word.substr(name.size() + 1);
    }
    else
    {
      options[name] = true;
    }
  }
  return options;
}
} // namespace pixelexact
