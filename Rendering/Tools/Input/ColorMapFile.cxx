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
  bool isLogarithmic = false;
  std::vector<std::array<double, 4>> points; ///< x, red, green, blue
  /// x, opacity, and the midpoint and sharpness of the part behind it, as VTK has them.
  std::vector<std::array<double, 4>> opacities;
  std::array<double, 3> nan{ 0.5, 0.5, 0.5 };
};

struct FileAndName
{
  std::string file;
  std::string name;   ///< empty: the only one
  std::string source; ///< option and file, for messages
};

bool HasSuffix(const std::string& file)
{
  return file.ends_with(".json") || file.ends_with(".xml");
}

FileAndName Split(const std::string& text, const std::string& option)
{
  FileAndName split{ text, {}, {} };
  const auto colon = text.rfind(':');
  if (!HasSuffix(text) && colon != std::string::npos && HasSuffix(text.substr(0, colon)))
  {
    split = { text.substr(0, colon), text.substr(colon + 1), {} };
  }
  split.source = option + ": '" + split.file + "'";
  return split;
}

[[noreturn]] void Fail(const std::string& source, const std::string& why)
{
  throw Error(source + ": " + why);
}

/// Four numbers a point.
std::vector<std::array<double, 4>> ReadPoints(
  const nlohmann::json& map, const char* key, const std::string& source)
{
  const auto numbers = map.value(key, std::vector<double>());
  if (numbers.size() % 4 != 0)
  {
    Fail(source,
      std::string(key) + " of '" + map.value("Name", std::string()) +
        "' are not four numbers each");
  }
  std::vector<std::array<double, 4>> points;
  points.reserve(numbers.size() / 4);
  for (std::size_t i = 0; i < numbers.size(); i += 4)
  {
    points.push_back({ numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3] });
  }
  return points;
}

std::vector<FileMap> ReadJson(const std::string& source, std::istream& stream)
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
      const auto logarithm = one.find("UseLogScale");
      map.isLogarithmic =
        logarithm != one.end() && *logarithm != 0 && *logarithm != false && !logarithm->is_null();
      map.points = ReadPoints(one, "RGBPoints", source);
      map.opacities = ReadPoints(one, "Points", source);
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
    Fail(source, std::string("it is no colour map in JSON: ") + error.what());
  }
  return maps;
}

std::vector<FileMap> ReadXml(const std::string& source, std::istream& stream)
{
  pugi::xml_document document;
  if (const auto done = document.load(stream); !done)
  {
    Fail(source, std::string("it is no XML: ") + done.description());
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
      if (point.attribute("o"))
      {
        map.opacities.push_back({ number(point, "x"), number(point, "o"), 0.5, 0.0 });
      }
    }
    if (const pugi::xml_node nan = node.child("NaN"))
    {
      map.nan = { number(nan, "r"), number(nan, "g"), number(nan, "b") };
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

void SetSpace(const std::string& source, const std::string& space, vtkColorTransferFunction& colors)
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
    Fail(source,
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
    Fail(wanted.source, "it holds no colour map");
  }
  if (wanted.name.empty() && maps.size() == 1)
  {
    return maps.front();
  }
  const auto found = std::ranges::find(maps, wanted.name, &FileMap::name);
  if (wanted.name.empty() || found == maps.end())
  {
    Fail(wanted.source,
      (wanted.name.empty() ? "it holds several maps; choose one as FILE:NAME, of "
                           : "it holds no '" + wanted.name + "'; there are ") +
        Listed(names));
  }
  return *found;
}

void Check(const std::string& source, const FileMap& map)
{
  if (map.ofCategories)
  {
    throw Unsupported(
      source + ": '" + map.name + "' has colours of categories, and values have none");
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
    Fail(source,
      "'" + map.name +
        "' needs two points or more, in ascending order, with colours between 0 and 1");
  }
}

FileMap Read(const FileAndName& wanted)
{
  const std::unique_ptr<std::istream> opened = OpenFileOrPipe(wanted.file);
  std::istream& stream = *opened;
  if (!stream)
  {
    Fail(wanted.source, "it cannot be opened");
  }
  FileMap map = Choose(wanted,
    wanted.file.ends_with(".json") ? ReadJson(wanted.source, stream)
                                   : ReadXml(wanted.source, stream));
  Check(wanted.source, map);
  return map;
}

/// The map's colours over [0, 1].
vtkSmartPointer<vtkColorTransferFunction> ColorsOf(const std::string& source, const FileMap& map)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  // Two colours at one place are a step.
  colors->AllowDuplicateScalarsOn();
  SetSpace(source, map.space, *colors);
  const double first = map.points.front()[0];
  const double length = map.points.back()[0] - first;
  for (const auto& [x, r, g, b] : map.points)
  {
    colors->AddRGBPoint((x - first) / length, r, g, b);
  }
  return colors;
}

/// Colours between which RGB is linear.
std::vector<TransferFunction::ColorPoint> ColorPointsOf(
  const std::string& source, const FileMap& map)
{
  std::vector<TransferFunction::ColorPoint> points;
  points.reserve(map.points.size());
  for (const auto& [x, r, g, b] : map.points)
  {
    points.push_back({ x, { r, g, b } });
  }
  if (map.space == "RGB")
  {
    return points;
  }
  if (map.space == "Step")
  {
    throw Unsupported(source +
      ": the colour space 'Step' has no transfer function; use two points "
      "at each step, in RGB");
  }
  constexpr int kParts = 64;
  const auto colors = ColorsOf(source, map);
  const double first = points.front().u;
  const double length = points.back().u - first;
  points.clear();
  points.reserve(kParts + 1);
  for (int i = 0; i <= kParts; ++i)
  {
    const double share = static_cast<double>(i) / kParts;
    TransferFunction::ColorPoint point{ first + share * length, {} };
    colors->GetColor(share, point.rgb.data());
    for (double& channel : point.rgb)
    {
      channel = std::clamp(channel, 0.0, 1.0); // conversions of colour spaces round
    }
    points.push_back(point);
  }
  return points;
}

std::vector<TransferFunction::OpacityPoint> OpacityPointsOf(
  const std::string& source, const FileMap& map)
{
  if (map.opacities.empty())
  {
    return { { map.points.front()[0], 0.0 }, { map.points.back()[0], 1.0 } };
  }
  std::vector<TransferFunction::OpacityPoint> points;
  points.reserve(3 * map.opacities.size());
  for (std::size_t i = 0; i < map.opacities.size(); ++i)
  {
    const auto& [x, alpha, midpoint, sharpness] = map.opacities[i];
    points.push_back({ x, alpha });
    if (i + 1 == map.opacities.size() || (midpoint == 0.5 && sharpness == 0.0))
    {
      continue;
    }
    if (!(midpoint >= 0.0 && midpoint <= 1.0) || (sharpness != 0.0 && sharpness != 1.0))
    {
      throw Unsupported(source + ": the opacity point at " + Short(x) + " has the sharpness " +
        Short(sharpness) + " and the midpoint " + Short(midpoint) +
        "; only 0 (linear) and 1 (a step) with midpoints from 0 to 1 are supported");
    }
    const auto& next = map.opacities[i + 1];
    const double at = x + midpoint * (next[0] - x);
    if (sharpness == 0.0)
    {
      points.push_back({ at, 0.5 * (alpha + next[1]) });
    }
    else
    {
      points.push_back({ at, alpha });
      points.push_back({ at, next[1] });
    }
  }
  return points;
}
} // namespace

bool NamesColorMapFile(const std::string& text)
{
  return HasSuffix(Split(text, {}).file);
}

vtkSmartPointer<vtkLookupTable> ReadColorMapFile(
  const std::string& text, const std::array<double, 2>& range)
{
  const FileAndName wanted = Split(text, "--colormap");
  const FileMap map = Read(wanted);
  return MakeColorTable(ColorsOf(wanted.source, map), map.nan, range);
}

TransferFunction ReadTransferFile(const std::string& text, double unit)
{
  const FileAndName wanted = Split(text, "--transfer");
  const FileMap map = Read(wanted);
  if (map.isLogarithmic)
  {
    throw Unsupported(wanted.source + ": '" + map.name +
      "' has a logarithmic scale (UseLogScale), which volumes have not; save it without");
  }
  return { ColorPointsOf(wanted.source, map), OpacityPointsOf(wanted.source, map), unit,
    wanted.source.c_str() };
}
} // namespace pixelexact
