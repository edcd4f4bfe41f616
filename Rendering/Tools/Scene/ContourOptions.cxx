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

#include "Trace/Contours/IntervalEdges.h"

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
constexpr int kUsualSubdivisions = 3;
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
  return fmt::format("{}: more than {} values; give fewer", option, ContourOptions::kMost);
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
    if (!ParseInteger(number, choice.count) || choice.count > ContourOptions::kMost)
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
  if (choice.values.size() > static_cast<std::size_t>(ContourOptions::kMost))
  {
    throw UsageError(TooMany(option));
  }
  return choice;
}

void ContourOptions::ReadColors(const std::string& text)
{
  TheColors.clear();
  if (text == "map")
  {
    return;
  }
  if (text.find(':') == std::string::npos)
  {
    TheColors.push_back(ReadColor(text, ','));
    return;
  }
  for (const std::string& color : SplitAt(text, ','))
  {
    TheColors.push_back(ReadColor(color, ':'));
  }
}

void ContourOptions::AddTo(CLI::App& added)
{
  Command = &added;
  const char* group = "Contours";
  const AddedOption contours = AddRead(
    added, kContours,
    [this](const std::string& text) { Choice = ReadContours(kContours, text, ','); }, "N|v1,v2,...",
    "Draw the lines on which the field has these values. A positive whole number N: N round "
    "values, "
    "evenly spaced, strictly inside the colour map's range (with --log by their logarithms). "
    "Several numbers with commas, one with a comma behind it (7,), or a number that is no such "
    "(10.0, -3, 0): these values")
                                 .Group(group);
  AddRead(
    added, "--contour-width",
    [this](const std::string& text)
    {
      double width = 0.0;
      if (!ParseNumber(text, width) ||
        !(width >= ContourStyle::kNarrowest && width <= ContourStyle::kWidest))
      {
        Refuse("--contour-width", text,
          fmt::format("a number from {} to {}", ContourStyle::kNarrowest, ContourStyle::kWidest));
      }
      Width = width;
    },
    "PIXELS",
    fmt::format("Their width in pixels, {} to {} (default: {})", ContourStyle::kNarrowest,
      ContourStyle::kWidest, ContourStyle().width))
    .Needs(contours)
    .Group(group);
  AddRead(
    added, "--contour-color", [this](const std::string& text) { ReadColors(text); }, kColorForm,
    "Their colour, 0 to 1 each (default: 0,0,0); one for each value, in the order of the values; "
    "or "
    "map: the value's in the colour map")
    .Needs(contours)
    .Group(group);
  AddFlag(added, "--contours-only", TheOnly,
    "Draw them on the background's colour, without those of the surface")
    .Needs(contours)
    .Group(group);
  AddNumberIfAny(added, "--contour-labels", LabelHeight,
    { LabelFont::kUsual, LabelFont::kSmallest, LabelFont::kLargest }, "PIXELS",
    fmt::format(
      "Write the values along the lines, where these are straight and apart, in letters of "
      "a height in whole pixels, {} to {}",
      LabelFont::kSmallest, LabelFont::kLargest))
    .Needs(contours)
    .Group(group);
  const AddedOption certifier = AddRead(
    added, "--certifier",
    [this](const std::string& text)
    {
      if (text != "exact" && text != "interval")
      {
        Refuse("--certifier", text, "exact or interval");
      }
      Method.subdivisions.reset();
      if (text == "interval")
      {
        Method.subdivisions = kUsualSubdivisions;
      }
    },
    "exact|interval",
    "How pixels are proven to have a contour or none: by bounds of second derivatives (exact, the "
    "default), or as in the paper by interval arithmetic along their edges")
                                  .Needs(contours)
                                  .Group(group);
  AddRead(
    added, "--subdivisions",
    [this](const std::string& text)
    {
      int count = 0;
      if (!ParseInteger(text, count) || count < 0 || count > kMostSubdivisions)
      {
        Refuse(
          "--subdivisions", text, fmt::format("a whole number from 0 to {}", kMostSubdivisions));
      }
      Subdivisions = count;
    },
    "N",
    fmt::format("How often --certifier interval halves an edge, 0 to {} (default: {})",
      kMostSubdivisions, kUsualSubdivisions))
    .Needs(certifier)
    .Group(group);
  AddFlag(added, "--interior", Method.interior,
    "Look for contours inside of pixels, too, on whose edges there are none: closed loops smaller "
    "than a pixel. On planes and quadrics; pixels that show another surface are undecided anyway")
    .Needs(contours)
    .Group(group);
  AddNumber(added, "--contour-effort", Effort, "FACTOR",
    "How many times as much as usual may be spent on pixels that are hard to decide, 0.001 to 1000 "
    "(default: 1, about 40 s of one core for a frame); what is left is undecided")
    .Needs(contours)
    .Group(group);
  const AddedOption shown = AddFlag(added, "--show-undecided-contours", ShowUndecided,
    "Paint pixels of which it could not be decided whether a contour goes through them, as "
    "--show-undecided does, too; else they show the lines between the samples alone")
                              .Needs(contours)
                              .Group(group);
  AddNumbers(added, "--undecided-contour-color", UndecidedColor, 3, "r,g,b",
    "Their colour, 0 to 1 each (default: 0,0.5,0.5)")
    .Needs(shown)
    .Group(group);
}

void ContourOptions::Check(const std::vector<LayerSettings>& layers) const
{
  CheckColor("--undecided-contour-color", UndecidedColor);
  if (Subdivisions && !Method.subdivisions)
  {
    throw UsageError("--subdivisions are those of --certifier interval; leave them out");
  }
  if (Method.interior && Method.subdivisions)
  {
    throw UsageError(
      "--interior: --certifier interval looks at edges alone, as in the paper; leave "
      "one of them out");
  }
  if (Effort && Method.subdivisions)
  {
    throw UsageError("--contour-effort: --certifier interval spends what --subdivisions say; leave "
                     "one of them out");
  }
  if (Effort && !(*Effort >= ContourMethod::kLeastEffort && *Effort <= ContourMethod::kMostEffort))
  {
    throw UsageError(fmt::format("--contour-effort {}: give a factor from {} to {}", *Effort,
      ContourMethod::kLeastEffort, ContourMethod::kMostEffort));
  }
  if (LabelHeight && *LabelHeight != std::floor(*LabelHeight))
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
    if (values > 0 && TheColors.size() > 1 && TheColors.size() != values)
    {
      throw UsageError(
        fmt::format("--contour-color: {} colours for {} values; give one, or one for each",
          TheColors.size(), values));
    }
  }
  if (TheOnly)
  {
    CheckEffectsWithoutColors(*this, *Command, layers);
  }
}

ContourStyle ContourOptions::Style() const
{
  ContourStyle style;
  style.width = Width.value_or(style.width);
  style.showUndecided = ShowUndecided || IsGiven(*Command, "--show-undecided");
  style.undecided = ToRgba(UndecidedColor.data());
  style.keepBeneath = LabelHeight.has_value();
  return style;
}

ContourMethod ContourOptions::HowTold() const
{
  ContourMethod method = Method;
  method.SetEffort(Effort.value_or(1.0));
  if (method.subdivisions)
  {
    method.subdivisions = Subdivisions.value_or(*method.subdivisions);
  }
  return method;
}

std::optional<int> ContourOptions::Labels() const
{
  return LabelHeight ? std::optional(static_cast<int>(*LabelHeight)) : std::nullopt;
}

ContourAppearance ContourOptions::MakeAppearance(const Rgba& background) const
{
  return { Style(), HowTold(), Labels(), TheOnly ? std::optional(background) : std::nullopt };
}
} // namespace pixelexact
