// SPDX-License-Identifier: BSD-3-Clause
#include "ColorOptions.h"

#include "Command.h"
#include "Options.h"
#include "Report.h"

#include "Core/Base/Error.h"
#include "VtkColorMap.h"
#include "VtkLook.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
std::array<double, 2> Log10(const std::array<double, 2>& range)
{
  return { std::log10(range[0]), std::log10(range[1]) };
}

/// The colours of `map`, which spans powers of ten, by value: what has no logarithm gets the colour
/// of NaN.
ColorMap ByLogarithm(ColorMap map)
{
  return [map = std::move(map)](std::span<const double> values, std::uint8_t* rgba)
  {
    std::vector<double> logarithms(values.size());
    std::transform(values.begin(), values.end(), logarithms.begin(),
      [](double v) { return v > 0.0 ? std::log10(v) : std::numeric_limits<double>::quiet_NaN(); });
    map(logarithms, rgba);
  };
}

std::string Names()
{
  return Listed(ColorMapNames());
}
} // namespace

void CheckMap(const char* option, const std::string& map)
{
  const std::vector<std::string> names = ColorMapNames();
  if (std::find(names.begin(), names.end(), map) == names.end())
  {
    throw UsageError(std::string(option) + ": there is no '" + map + "'; there are " + Names());
  }
}

void CheckColor(const char* option, const std::vector<double>& color)
{
  if (std::any_of(color.begin(), color.end(), [](double c) { return c < 0.0 || c > 1.0; }))
  {
    throw UsageError(std::string(option) + ": red, green and blue lie between 0 and 1");
  }
}

void CheckLogarithm(const char* option, const RangeChoice& range)
{
  if (range.of == RangeChoice::Of::Ends && !(range.ends[0] > 0.0))
  {
    throw UsageError(std::string(option) + ": --log needs a range above 0, and this begins at " +
      Short(range.ends[0]));
  }
}

void ColorOptions::AddTo(CLI::App& command)
{
  const char* group = "Colours";
  const AddedOption range = AddRead(
    command, "--range",
    [this](const std::string& text) { TheRange = ReadRange("--range", text, ','); },
    "cut|field|a,b",
    "Values of the colour map's ends: cut, those that the picture shows (default); field, a proven "
    "enclosure of all values over the mesh; or two numbers, beyond which values take the colours "
    "of "
    "the ends")
                              .Group(group);
  const AddedOption map =
    AddText(command, "--colormap", Map, "NAME", "Colour map: " + Names() + " (default: viridis)")
      .Group(group);
  const AddedOption log = AddFlag(command, "--log", Log,
    "Colour by the logarithm of the value; values that have none get the colour of NaN")
                            .Group(group);
  const AddedOption nan = AddNumbers(command, "--nan-color", NanColor, 3, "r,g,b",
    "Colour of values that are no numbers, 0 to 1 each (default: the map's)")
                            .Group(group);
  AddNumbers(command, "--color", Color, 3, "r,g,b",
    "One colour in the place of the map's, 0 to 1 each (default where the input has no field: "
    "0.6,0.7,0.8)")
    .Excludes(range)
    .Excludes(map)
    .Excludes(log)
    .Excludes(nan)
    .Group(group);
  AddNumbers(command, "--background", Background, 3, "r,g,b",
    "Colour where there is nothing, 0 to 1 each (default: white)")
    .Group(group);
}

void ColorOptions::Check() const
{
  CheckColor("--nan-color", NanColor);
  CheckColor("--background", Background);
  CheckColor("--color", Color);
  if (Log)
  {
    CheckLogarithm("--range", TheRange);
  }
  CheckMap("--colormap", Map);
}

std::optional<std::array<double, 3>> ColorOptions::Solid() const
{
  return Color.empty() ? std::nullopt : std::optional(std::array{ Color[0], Color[1], Color[2] });
}

ColorMap ColorOptions::MapOver(
  const std::array<double, 2>& range, const std::optional<std::string>& map) const
{
  const auto table = MakeColorMap(map.value_or(Map), Log ? Log10(range) : range);
  if (!NanColor.empty())
  {
    table->SetNanColor(NanColor[0], NanColor[1], NanColor[2], 1.0);
  }
  const ColorMap colors = ToColorMap(table);
  return Log ? ByLogarithm(colors) : colors;
}

Rgba ColorOptions::BackgroundColor() const
{
  return ToRgba(Background.data());
}

std::vector<std::uint8_t> ColorOptions::Flatten(const Frame& frame) const
{
  const std::vector<std::uint8_t>& image = frame.Image();
  const std::size_t pixels = image.size() / 4;
  std::vector<std::uint8_t> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const std::uint8_t* color = &image[4 * i];
    const double alpha = color[3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double mixed = alpha * color[c] + (1.0 - alpha) * 255.0 * Background[c];
      rgb[3 * i + c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
  }
  return rgb;
}
} // namespace pixelexact
