// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ColorMapFile.h"

#include "Base/FileOrPipe.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"
#include "Views/VtkColorMap.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pixelexact
{
namespace
{
struct FileMap
{
  std::string name;
  std::string space;
  bool ofCategories = false;
  std::vector<std::array<double, 4>> points; ///< x, red, green, blue
  std::array<double, 3> nan{ 0.5, 0.5, 0.5 };
};

struct FileAndName
{
  std::string file;
  std::string name; ///< empty: the only one
};

bool HasSuffix(const std::string& file)
{
  return file.ends_with(".json") || file.ends_with(".xml");
}

FileAndName Split(const std::string& text)
{
  const auto colon = text.rfind(':');
  if (!HasSuffix(text) && colon != std::string::npos && HasSuffix(text.substr(0, colon)))
  {
    return { text.substr(0, colon), text.substr(colon + 1) };
  }
  return { text, {} };
}

[[noreturn]] void Fail(const std::string& file, const std::string& why)
{
  throw Error("--colormap: '" + file + "': " + why);
}

std::vector<FileMap> ReadJson(const std::string& file, std::istream& stream)
{
  std::vector<FileMap> maps;
  try
  {
    nlohmann::json all = nlohmann::json::parse(stream);
    all = all.is_array() ? all : nlohmann::json::array({ all });
    for (const nlohmann::json& one : all)
    {
      FileMap map;
      map.name = one.value("Name", std::string());
      map.space = one.value("ColorSpace", std::string("RGB"));
      map.ofCategories = one.contains("IndexedColors") && !one.contains("RGBPoints");
      const auto numbers = one.value("RGBPoints", std::vector<double>());
      if (numbers.size() % 4 != 0)
      {
        Fail(file, "RGBPoints of '" + map.name + "' are not four numbers each");
      }
      for (std::size_t i = 0; i < numbers.size(); i += 4)
      {
        map.points.push_back({ numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3] });
      }
      const auto nan = one.value("NanColor", std::vector<double>());
      if (nan.size() >= 3)
      {
        std::copy_n(nan.begin(), 3, map.nan.begin());
      }
      maps.push_back(std::move(map));
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    Fail(file, std::string("it is no colour map in JSON: ") + error.what());
  }
  return maps;
}

std::vector<FileMap> ReadXml(const std::string& file, std::istream& stream)
{
  pugi::xml_document document;
  if (const auto done = document.load(stream); !done)
  {
    Fail(file, std::string("it is no XML: ") + done.description());
  }
  std::vector<FileMap> maps;
  for (const pugi::xpath_node& found : document.select_nodes("//ColorMap"))
  {
    const pugi::xml_node node = found.node();
    FileMap map;
    map.name = node.attribute("name").as_string();
    map.space = node.attribute("space").as_string("RGB");
    map.ofCategories = node.attribute("indexedLookup").as_bool();
    const double none = std::nan("");
    const auto number = [none](const pugi::xml_node& of, const char* name)
    { return of.attribute(name).as_double(none); };
    for (const pugi::xml_node& point : node.children("Point"))
    {
      map.points.push_back(
        { number(point, "x"), number(point, "r"), number(point, "g"), number(point, "b") });
    }
    if (const pugi::xml_node nan = node.child("NaN"))
    {
      map.nan = { number(nan, "r"), number(nan, "g"), number(nan, "b") };
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

void SetSpace(const std::string& file, const std::string& space, vtkColorTransferFunction& colors)
{
  if (space == "RGB")
  {
    colors.SetColorSpaceToRGB();
  }
  else if (space == "HSV" || space == "HSVNoWrap")
  {
    // ParaView does not wrap hues by default.
    colors.SetColorSpaceToHSV();
    colors.HSVWrapOff();
  }
  else if (space == "Lab" || space == "CIELAB")
  {
    colors.SetColorSpaceToLab();
  }
  else if (space == "Lab/CIEDE2000")
  {
    colors.SetColorSpaceToLabCIEDE2000();
  }
  else if (space == "Diverging")
  {
    colors.SetColorSpaceToDiverging();
  }
  else if (space == "Step")
  {
    colors.SetColorSpaceToStep();
  }
  else
  {
    Fail(file,
      "its colour space '" + space +
        "' is none of RGB, HSV, Lab, Lab/CIEDE2000, Diverging and Step");
  }
}

FileMap Choose(const FileAndName& wanted, const std::vector<FileMap>& maps)
{
  std::vector<std::string> names;
  std::ranges::transform(
    maps, std::back_inserter(names), [](const FileMap& map) { return "'" + map.name + "'"; });
  if (maps.empty())
  {
    Fail(wanted.file, "it holds no colour map");
  }
  if (wanted.name.empty() && maps.size() == 1)
  {
    return maps.front();
  }
  const auto found = std::ranges::find(maps, wanted.name, &FileMap::name);
  if (wanted.name.empty() || found == maps.end())
  {
    Fail(wanted.file,
      (wanted.name.empty() ? "it holds several maps; choose one as FILE:NAME, of "
                           : "it holds no '" + wanted.name + "'; there are ") +
        Listed(names));
  }
  return *found;
}

void Check(const std::string& file, const FileMap& map)
{
  if (map.ofCategories)
  {
    throw Unsupported("--colormap: '" + file + "': '" + map.name +
      "' has colours of categories, and values have none");
  }
  bool sound = map.points.size() >= 2 && map.points.front()[0] < map.points.back()[0];
  for (std::size_t i = 0; i < map.points.size(); ++i)
  {
    const auto& [x, r, g, b] = map.points[i];
    sound = sound && std::isfinite(x) && (i == 0 || x >= map.points[i - 1][0]);
    for (const double c : { r, g, b })
    {
      sound = sound && c >= 0.0 && c <= 1.0;
    }
  }
  if (!sound)
  {
    Fail(file,
      "'" + map.name +
        "' needs two points or more, in ascending order, with colours between 0 and 1");
  }
}
} // namespace

bool NamesColorMapFile(const std::string& text)
{
  return HasSuffix(Split(text).file);
}

vtkSmartPointer<vtkLookupTable> ReadColorMapFile(
  const std::string& text, const std::array<double, 2>& range)
{
  const FileAndName wanted = Split(text);
  const std::unique_ptr<std::istream> opened = OpenFileOrPipe(wanted.file);
  std::istream& stream = *opened;
  if (!stream)
  {
    Fail(wanted.file, "it cannot be opened");
  }
  const FileMap map = Choose(wanted,
    wanted.file.ends_with(".json") ? ReadJson(wanted.file, stream) : ReadXml(wanted.file, stream));
  Check(wanted.file, map);
  vtkNew<vtkColorTransferFunction> colors;
  // Two colours at one place are a step.
  colors->AllowDuplicateScalarsOn();
  SetSpace(wanted.file, map.space, *colors);
  const double first = map.points.front()[0];
  const double length = map.points.back()[0] - first;
  for (const auto& [x, r, g, b] : map.points)
  {
    colors->AddRGBPoint((x - first) / length, r, g, b);
  }
  return MakeColorTable(colors, map.nan, range);
}
} // namespace pixelexact
