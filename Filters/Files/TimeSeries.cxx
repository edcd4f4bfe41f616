// SPDX-License-Identifier: BSD-3-Clause
#include "Files/TimeSeries.h"

#include "Core/Base/Error.h"
#include "Core/Base/ParseWhole.h"
#include "Files/VtkHdfGrid.h"
#include "Formats/FileText.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

namespace pixelexact
{
namespace
{
[[noreturn]] void Fail(const std::string& file, const std::string& why)
{
  throw Error("cannot read '" + file + "': " + why);
}

/// The children of the file's root element, which must be of that type of VTK's XML formats.
pugi::xml_node Load(pugi::xml_document& document, const std::string& file, const char* type)
{
  if (IsPipeOrDevice(file))
  {
    Fail(file, kPipeRemedy);
  }
  const auto result = document.load_file(file.c_str());
  if (!result)
  {
    Fail(file,
      std::string(result.description()) +
        (result.status == pugi::status_file_not_found
            ? ""
            : ", at byte " + std::to_string(result.offset)));
  }
  const auto root = document.child("VTKFile");
  if (root.attribute("type").value() != std::string(type) || !root.child(type))
  {
    Fail(file, std::string("it is not a VTK XML file of type ") + type);
  }
  return root.child(type);
}

std::string BesideOf(const std::string& list, const std::string& name)
{
  const std::filesystem::path path(name);
  return path.is_absolute() ? name : (std::filesystem::path(list).parent_path() / path).string();
}

double ParseTime(const std::string& file, const pugi::xml_attribute& attribute)
{
  double time = 0.0;
  if (!ParseWhole(WithoutBlanks(attribute ? attribute.value() : "0"), time) || !std::isfinite(time))
  {
    Fail(file, std::string("'") + attribute.value() + "' is no time; mend its attribute timestep");
  }
  return time;
}

std::string LabelOf(const pugi::xml_node& dataSet)
{
  std::string label;
  for (const char* attribute : { "group", "part", "name" })
  {
    label += std::string(attribute) + "=" + dataSet.attribute(attribute).value() + " ";
  }
  return label;
}
} // namespace

std::vector<TimeStep> ReadCollection(const std::string& file)
{
  pugi::xml_document document;
  std::map<double, std::vector<GridPart>> byTime;
  for (const auto& dataSet : Load(document, file, "Collection").children("DataSet"))
  {
    const std::string name = dataSet.attribute("file").value();
    if (name.empty())
    {
      Fail(file, "a DataSet names no file");
    }
    auto& parts = byTime[ParseTime(file, dataSet.attribute("timestep"))];
    const GridPart part{ BesideOf(file, name), file, LabelOf(dataSet),
      static_cast<int>(parts.size()) };
    // A run that was continued may list its last step twice; the same file counts once.
    if (std::ranges::find(parts, part.file, &GridPart::file) == parts.end())
    {
      parts.push_back(part);
    }
  }
  if (byTime.empty())
  {
    Fail(file, "it lists no DataSet");
  }
  std::vector<TimeStep> steps;
  steps.reserve(byTime.size());
  for (auto& [time, parts] : byTime)
  {
    steps.push_back({ time, std::move(parts) });
  }
  return steps;
}

std::vector<TimeStep> NumberFiles(const std::vector<std::string>& files)
{
  std::vector<TimeStep> steps;
  steps.reserve(files.size());
  for (const auto& file : files)
  {
    steps.push_back({ static_cast<double>(steps.size()), { { file } } });
  }
  return steps;
}

bool IsVtkHdfName(const std::string& file)
{
  const std::string suffix = LowerSuffix(file);
  return suffix == ".vtkhdf" || suffix == ".hdf";
}

std::vector<TimeStep> ListHdfSteps(const std::vector<std::string>& files)
{
  std::vector<TimeStep> steps;
  std::size_t timed = 0;
  for (const std::string& file : files)
  {
    std::vector<double> times;
    try
    {
      times = VtkHdfTimes(file);
    }
    catch (const Error& error)
    {
      Fail(file, error.what());
    }
    timed += times.empty() ? 0 : 1;
    for (std::size_t step = 0; step < times.size(); ++step)
    {
      GridPart part{ file };
      part.step = step;
      steps.push_back({ times[step], { part }, true });
    }
  }
  if (timed == 0)
  {
    return NumberFiles(files);
  }
  if (timed < files.size())
  {
    Fail(files.front(), "some of the files have time steps and others have none; name them apart");
  }
  std::ranges::stable_sort(steps, {}, &TimeStep::time);
  return steps;
}

std::vector<GridPart> ReadPieces(const GridPart& part)
{
  pugi::xml_document document;
  std::vector<GridPart> pieces;
  for (const auto& piece : Load(document, part.file, "PUnstructuredGrid").children("Piece"))
  {
    const std::string name = piece.attribute("Source").value();
    if (name.empty())
    {
      Fail(part.file, "a Piece names no Source");
    }
    pieces.push_back({ BesideOf(part.file, name), part.file, part.label, part.entry });
  }
  if (pieces.empty())
  {
    Fail(part.file, "it lists no Piece");
  }
  return pieces;
}

std::string LowerSuffix(const std::string& file)
{
  std::string suffix = std::filesystem::path(file).extension().string();
  std::ranges::transform(
    suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}
} // namespace pixelexact
