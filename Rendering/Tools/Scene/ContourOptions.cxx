// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ContourOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Scene/ColorOptions.h"
#include "Scene/Effects.h"
#include "Scene/LayerOptions.h"

#include "Frames/ContourLabels.h"
#include "Views/VtkLook.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr const char* kContours = "--contours";
constexpr const char* kRound = "round";
constexpr const char* kColorForm = "r,g,b|r:g:b,r:g:b,...|map";

Rgba ReadColor(const std::string& text, char separator)
{
  std::vector<double> color;
  for (const std::string& part : SplitAt(text, separator))
  {
    double channel = 0.0;
    if (!ParseNumber(part, channel) || !std::isfinite(channel))
    {
      Refuse("--contour-color", text, kColorForm);
    }
    color.push_back(channel);
  }
  if (color.size() != 3)
  {
    Refuse("--contour-color", text, kColorForm);
  }
  CheckColor("--contour-color", color);
  return ToRgba(color.data());
}

std::string TooMany(const std::string& option)
{
  return fmt::format("{}: more than {} values; give fewer", option, ContourOptions::kMax);
}
} // namespace

ContourRule ReadContours(const std::string& option, const std::string& text, char separator)
{
  ContourRule choice;
  const std::string_view number =
    std::string_view(text).substr(text.starts_with(kRound) ? std::string_view(kRound).size() : 0);
  const bool digits =
    !number.empty() && std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
  if (digits && number.find_first_not_of('0') != std::string::npos)
  {
    if (!ParseInteger(number, choice.count) || choice.count > ContourOptions::kMax)
    {
      throw UsageError(TooMany(option));
    }
    return choice;
  }
  const bool single = text.find(separator) + 1 == text.size();
  for (const std::string& part :
    SplitAt(single ? text.substr(0, text.size() - 1) : text, separator))
  {
    double value = 0.0;
    if (!ParseNumber(part, value) || !std::isfinite(value))
    {
      Refuse(option, text,
        fmt::format("a number of contours, or finite values with '{0}' between them (7{0} is the "
                    "value 7)",
          separator));
    }
    if (std::ranges::find(choice.values, value) != choice.values.end())
    {
      throw UsageError(fmt::format("{}: '{}' is there twice; give it once", option, part));
    }
    choice.values.push_back(value);
  }
  if (choice.values.size() > static_cast<std::size_t>(ContourOptions::kMax))
  {
    throw UsageError(TooMany(option));
  }
  return choice;
}

void ContourOptions::ReadColors(const std::string& text)
{
  colors_.clear();
  if (text == "map")
  {
    return;
  }
  if (text.find(':') == std::string::npos)
  {
    colors_.push_back(ReadColor(text, ','));
    return;
  }
  for (const std::string& color : SplitAt(text, ','))
  {
    colors_.push_back(ReadColor(color, ':'));
  }
}

void ContourOptions::AddTo(CLI::App& added)
{
  Command = &added;
  Bind(added, kContours,
    [this](const std::string& text) { Choice = ReadContours(kContours, text, ','); });
  Bind(added, "--contour-width", Width);
  Bind(added, "--contour-color", [this](const std::string& text) { ReadColors(text); });
  Bind(added, "--contours-only", only_);
  Bind(added, "--contour-labels", LabelHeight);
  Bind(added, "--certifier", [this](const std::string& text) { Interval = text == "interval"; });
  Bind(added, "--subdivisions", Subdivisions);
  Bind(added, "--interior", Method.interior);
  Bind(added, "--contour-effort", Effort);
  Bind(added, "--show-undecided-contours", ShowUndecided);
  Bind(added, "--undecided-contour-color", UndecidedColor);
}

void ContourOptions::Check(const std::vector<LayerSettings>& layers) const
{
  if (IsGiven(*Command, "--subdivisions") && !Interval)
  {
    throw UsageError("--subdivisions are those of --certifier interval; leave them out");
  }
  if (Method.interior && Interval)
  {
    throw UsageError(
      "--interior: --certifier interval looks at edges alone, as in the paper; leave "
      "one of them out");
  }
  if (IsGiven(*Command, "--contour-effort") && Interval)
  {
    throw UsageError("--contour-effort: --certifier interval spends what --subdivisions say; leave "
                     "one of them out");
  }
  if (LabelHeight && LabelHeight->Pixels() != std::floor(LabelHeight->Pixels()))
  {
    throw UsageError("--contour-labels: a height is a whole number of pixels");
  }
  if (!AreGiven())
  {
    return;
  }
  for (const LayerSettings& layer : layers)
  {
    const std::size_t values = layer.contours.value_or(*Choice).Count();
    if (values > 0 && colors_.size() > 1 && colors_.size() != values)
    {
      throw UsageError(
        fmt::format("--contour-color: {} colours for {} values; give one, or one for each",
          colors_.size(), values));
    }
  }
  if (only_)
  {
    CheckEffectsWithoutColors(*this, *Command, layers);
  }
}

void ContourOptions::ResolveLengths(const std::optional<double>& dpi)
{
  Width.Resolve(dpi);
  if (LabelHeight && LabelHeight->inPoints)
  {
    LabelHeight->Resolve(dpi);
    LabelHeight->value = std::round(LabelHeight->value);
  }
}

ContourStyle ContourOptions::Style() const
{
  ContourStyle style;
  style.width = Width.Pixels();
  style.showUndecided = ShowUndecided;
  style.undecided = ToRgba(UndecidedColor.data());
  style.keepBeneath = LabelHeight.has_value();
  return style;
}

ContourMethod ContourOptions::ProofMethod() const
{
  ContourMethod method = Method;
  method.SetEffort(Effort);
  if (Interval)
  {
    method.subdivisions = Subdivisions;
  }
  return method;
}

std::optional<int> ContourOptions::Labels() const
{
  return LabelHeight ? std::optional(static_cast<int>(LabelHeight->Pixels())) : std::nullopt;
}

ContourAppearance ContourOptions::MakeAppearance(const Rgba& background) const
{
  return { Style(), ProofMethod(), Labels(), only_ ? std::optional(background) : std::nullopt };
}
} // namespace pixelexact
