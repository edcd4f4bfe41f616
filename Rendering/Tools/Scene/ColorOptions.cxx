// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ColorOptions.h"

#include "Base/Command.h"
#include "Base/Nearest.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Input/ColorMapFile.h"

#include "Core/Base/Error.h"
#include "Views/VtkColorMap.h"
#include "Views/VtkLook.h"

#include <fmt/format.h>
#include <vtkLookupTable.h>

#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkLookupTable> TableOf(const std::string& map, const std::array<double, 2>& range)
{
  return NamesColorMapFile(map) ? ReadColorMapFile(map, range) : MakeColorMap(map, range);
}

constexpr const char* kBackgroundForm = "white, black, none or r,g,b, 0 to 1 each";

std::optional<std::array<double, 3>> ReadBackground(const std::string& text)
{
  if (text == "none")
  {
    return std::nullopt;
  }
  if (text == "white" || text == "black")
  {
    const double all = text == "white" ? 1.0 : 0.0;
    return std::array{ all, all, all };
  }
  const std::vector<double> rgb = ReadNumbers("--background", text, 3, kBackgroundForm);
  CheckColor("--background", rgb);
  return std::array{ rgb[0], rgb[1], rgb[2] };
}
} // namespace

void CheckMap(const char* option, const std::string& map)
{
  if (NamesColorMapFile(map))
  {
    (void)ReadColorMapFile(map, { 0.0, 1.0 });
    return;
  }
  if (!HasColorMap(map))
  {
    const std::vector<std::string> names = ColorMapNames();
    throw UsageError(fmt::format("{}: there is no '{}'; there are {}, each reversed with _r after "
                                 "its name, and files of ParaView's, .json and .xml{}",
      option, map, Listed(names), Suggestion(names, map)));
  }
}

void CheckLogarithm(const char* option, const RangeRule& range)
{
  if (range.symmetric)
  {
    throw UsageError(
      std::string(option) + ": --log needs a range above 0, and a symmetric one is not");
  }
  if (range.of == RangeRule::Of::Ends && !(range.ends[0] > 0.0))
  {
    throw UsageError(std::string(option) + ": --log needs a range above 0, and this begins at " +
      Short(range.ends[0]));
  }
}

void ColorOptions::AddTo(CLI::App& command)
{
  Bind(command, "--range",
    [this](const std::string& text) { range_ = ReadRange("--range", text, ','); });
  Bind(command, "--colormap", Map);
  Bind(command, "--bands", bands_);
  Bind(command, "--log", Log);
  Bind(command, "--nan-color", NanColor);
  Bind(command, "--color", Color);
  Bind(command, "--background",
    [this](const std::string& text) { Background = ReadBackground(text); });
}

void ColorOptions::AddUndecidedTo(CLI::App& command)
{
  Bind(command, "--show-undecided", ShowUndecided);
  Bind(command, "--undecided-color", UndecidedColor);
}

std::optional<Rgba> ColorOptions::Undecided() const
{
  return ShowUndecided ? std::optional(ToRgba(UndecidedColor.data())) : std::nullopt;
}

void ColorOptions::Check() const
{
  if (Log)
  {
    CheckLogarithm("--range", range_);
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
  const auto table = TableOf(map.value_or(Map), range);
  SetScale(*table);
  return ToColorMap(table);
}

void ColorOptions::SetScale(vtkLookupTable& table) const
{
  if (Log)
  {
    table.SetScaleToLog10();
  }
  if (!NanColor.empty())
  {
    table.SetNanColor(NanColor[0], NanColor[1], NanColor[2], 1.0);
  }
}

vtkSmartPointer<vtkLookupTable> ColorOptions::TableOver(
  const std::array<double, 2>& range, const std::optional<std::string>& map) const
{
  const auto smooth = TableOf(map.value_or(Map), { 0.0, 1.0 });
  const int count = bands_.value_or(static_cast<int>(smooth->GetNumberOfTableValues()));
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(range[0], range[1]);
  for (int i = 0; i < count; ++i)
  {
    const auto at = static_cast<vtkIdType>(
      (i + 0.5) / count * static_cast<double>(smooth->GetNumberOfTableValues()));
    table->SetTableValue(i, smooth->GetTableValue(at));
  }
  table->SetNanColor(smooth->GetNanColor());
  SetScale(*table);
  return table;
}

Rgba ColorOptions::BackgroundColor() const
{
  return Background ? ToRgba(Background->data()) : Rgba{ 255, 255, 255, 0 };
}

Image ColorOptions::Flatten(const Frame& frame) const
{
  const std::vector<std::uint8_t>& pixels = frame.Image();
  Image image{ frame.width, frame.height, Background ? 3 : 4, {} };
  if (!Background)
  {
    image.pixels = pixels;
    return image;
  }
  const std::size_t count = pixels.size() / 4;
  image.pixels.resize(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint8_t* color = &pixels[4 * i];
    const double alpha = color[3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double mixed = alpha * color[c] + (1.0 - alpha) * 255.0 * (*Background)[c];
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
  }
  return image;
}
} // namespace pixelexact
