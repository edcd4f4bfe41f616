// SPDX-License-Identifier: BSD-3-Clause
// Names of dimensions and variables are those of "EXODUS: A Finite Element Data Model" (Sandia
// National Laboratories), appendix "Exodus data model as netCDF".
#include "Formats/Exodus/ExodusFile.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <span>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr std::int64_t kMaxCount = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMaxNodes = 1000;     ///< of an element
constexpr std::int64_t kMaxGroups = 1 << 20; ///< blocks, or side sets

void Require(bool sound)
{
  if (!sound)
  {
    throw InvalidData(
      "its numbers contradict each other; it is damaged or cut short: copy it again.");
  }
}

void RequireRange(
  const std::vector<std::int64_t>& numbers, std::int64_t lowest, std::int64_t highest)
{
  Require(std::ranges::all_of(
    numbers, [=](std::int64_t number) { return number >= lowest && number <= highest; }));
}

std::string Trimmed(const std::string& text)
{
  const auto begin = text.find_first_not_of(" \t");
  const auto end = text.find_last_not_of(" \t");
  return begin == std::string::npos ? std::string() : text.substr(begin, end + 1 - begin);
}

std::string NameAt(const std::vector<std::string>& names, std::int64_t place)
{
  return place <= std::ssize(names) ? names[static_cast<std::size_t>(place - 1)] : std::string();
}

using Endings = std::span<const std::string_view>;
constexpr std::array<std::string_view, 2> kPlane{ "x", "y" };
constexpr std::array<std::string_view, 3> kSpace{ "x", "y", "z" };
constexpr std::array<std::string_view, 2> kAxial{ "r", "z" };
constexpr std::array<std::string_view, 6> kTensor{ "xx", "yy", "zz", "xy", "xz", "yz" };

/// Whether a name consists of `begin` and `ending`.
bool Is(const std::string& name, std::string_view begin, std::string_view ending)
{
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return name.size() == begin.size() + ending.size() && name.starts_with(begin) &&
    std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
      [&](char letter, char own) { return same(own, letter); });
}

/// The number of variables from `first` on that are components with these endings; 0: the endings
/// do not fit.
std::size_t CountComponents(
  const std::vector<std::string>& variables, std::size_t first, Endings endings)
{
  const std::string& name = variables[first];
  if (name.size() <= endings[0].size() || first + endings.size() > variables.size())
  {
    return 0;
  }
  const std::string_view begin(name.data(), name.size() - endings[0].size());
  for (std::size_t i = 0; i < endings.size(); ++i)
  {
    if (!Is(variables[first + i], begin, endings[i]))
    {
      return 0;
    }
  }
  return endings.size();
}
} // namespace

ExodusFile::ExodusFile(const std::string& path)
  : File(OpenNetcdf(path))
{
  NodeCount = Count("num_nodes", kMaxCount);
  const std::int64_t elements = Count("num_elem", kMaxCount);
  Directions = static_cast<int>(Count("num_dim", 3));
  Require(NodeCount == 0 || Directions > 0);
  const std::int64_t blocks = Count("num_el_blk", kMaxGroups);
  const std::vector<std::int64_t> ids = NumbersOf("eb_prop1", blocks);
  const std::vector<std::string> names = NamesOf("eb_names");
  for (std::int64_t place = 1; place <= blocks; ++place)
  {
    AddBlock(
      place, ids.empty() ? place : ids[static_cast<std::size_t>(place - 1)], NameAt(names, place));
  }
  Require(ElementCount <= elements);
}

std::int64_t ExodusFile::Count(const std::string& dimension, std::int64_t largest) const
{
  const std::size_t count = File->Dimension(dimension).value_or(0);
  Require(count <= static_cast<std::size_t>(largest));
  return static_cast<std::int64_t>(count);
}

std::vector<std::string> ExodusFile::NamesOf(const std::string& variable) const
{
  std::vector<std::string> names =
    File->Shape(variable) ? File->Texts(variable) : std::vector<std::string>();
  std::ranges::transform(names, names.begin(), &Trimmed);
  return names;
}

std::vector<std::int64_t> ExodusFile::NumbersOf(
  const std::string& variable, std::int64_t count) const
{
  if (!File->Shape(variable))
  {
    return {};
  }
  std::vector<std::int64_t> numbers = File->Integers(variable);
  Require(std::ssize(numbers) == count);
  return numbers;
}

void ExodusFile::AddBlock(std::int64_t place, std::int64_t id, const std::string& name)
{
  Block block{ id, {}, name, 0, 0, ElementCount + 1, std::to_string(place) };
  block.elements = Count("num_el_in_blk" + block.suffix, kMaxCount);
  if (block.elements == 0)
  {
    return;
  }
  const std::string connectivity = "connect" + block.suffix;
  const auto shape = File->Shape(connectivity);
  block.type = shape ? File->TextAttribute(connectivity, "elem_type") : std::string();
  block.type = Trimmed(block.type);
  std::ranges::transform(
    block.type, block.type.begin(), [](unsigned char c) { return std::toupper(c); });
  block.nodes = static_cast<int>(Count("num_nod_per_el" + block.suffix, kMaxCount));
  if (block.type.starts_with("BEX"))
  {
    // The nodes of these elements are not the file's nodes.
    throw Unsupported("block " + std::to_string(id) + " has elements of type " + block.type +
      " (Bezier extraction), whose functions are splines; write the mesh with Lagrange elements");
  }
  ElementCount += block.elements;
  Contents.push_back(block);
}

std::vector<std::int64_t> ExodusFile::Connectivity(const Block& block) const
{
  Require(block.nodes >= 1 && block.nodes <= kMaxNodes);
  std::vector<std::int64_t> nodes = File->Integers("connect" + block.suffix);
  Require(std::ssize(nodes) == block.elements * block.nodes);
  RequireRange(nodes, 1, NodeCount);
  std::ranges::for_each(nodes, [](std::int64_t& node) { --node; });
  return nodes;
}

std::vector<ExodusFile::SideSet> ExodusFile::SideSets() const
{
  const std::int64_t count = Count("num_side_sets", kMaxGroups);
  const std::vector<std::int64_t> ids = NumbersOf("ss_prop1", count);
  const std::vector<std::string> names = NamesOf("ss_names");
  std::vector<SideSet> sets;
  for (std::int64_t place = 1; place <= count; ++place)
  {
    const std::string suffix = std::to_string(place);
    const std::int64_t sides = Count("num_side_ss" + suffix, kMaxCount);
    SideSet set{ ids.empty() ? place : ids[static_cast<std::size_t>(place - 1)],
      NameAt(names, place), {}, {} };
    if (sides > 0)
    {
      set.elements = File->Integers("elem_ss" + suffix);
      set.sides = File->Integers("side_ss" + suffix);
      Require(std::ssize(set.elements) == sides && std::ssize(set.sides) == sides);
      RequireRange(set.elements, 1, ElementCount);
    }
    // A set without sides is kept for its name.
    sets.push_back(std::move(set));
  }
  return sets;
}

std::int64_t ExodusFile::NodeSets() const
{
  return Count("num_node_sets", kMaxCount);
}

std::vector<double> ExodusFile::Times() const
{
  return File->Shape("time_whole") ? File->Reals("time_whole") : std::vector<double>();
}

std::vector<double> ExodusFile::Coordinates(int direction) const
{
  constexpr std::array kNames{ "coordx", "coordy", "coordz" };
  const auto index = static_cast<std::size_t>(direction);
  if (direction >= Directions)
  {
    return {};
  }
  // Old files store all coordinates in one variable.
  std::vector<double> values = File->Shape("coord")
    ? File->Reals("coord", NetcdfFile::Places(&index, 1))
    : File->Reals(kNames[index]);
  Require(std::ssize(values) == NodeCount);
  return values;
}

bool ExodusFile::HasSingleCoordinates() const
{
  return NodeCount > 0 && File->IsSingle(File->Shape("coord") ? "coord" : "coordx");
}

std::vector<double> ExodusFile::AtNodes(std::size_t variable, std::size_t step) const
{
  // Old files store the values of all fields in one variable.
  const std::string own = "vals_nod_var" + std::to_string(variable + 1);
  std::vector<double> values = File->Shape(own)
    ? File->Reals(own, std::array{ step })
    : File->Reals("vals_nod_var", std::array{ step, variable });
  Require(std::ssize(values) == NodeCount);
  return values;
}

std::optional<std::vector<double>> ExodusFile::OfElements(
  std::size_t variable, const Block& block, std::size_t step) const
{
  const std::string name = "vals_elem_var" + std::to_string(variable + 1) + "eb" + block.suffix;
  if (!File->Shape(name))
  {
    return std::nullopt;
  }
  std::vector<double> values = File->Reals(name, std::array{ step });
  Require(std::ssize(values) == block.elements);
  return values;
}

std::vector<ExodusField> JoinComponents(const std::vector<std::string>& variables)
{
  std::vector<ExodusField> fields;
  for (std::size_t first = 0; first < variables.size(); first += fields.back().count)
  {
    ExodusField field{ variables[first], first, 1 };
    for (const Endings endings :
      { Endings(kPlane), Endings(kSpace), Endings(kAxial), Endings(kTensor) })
    {
      const std::size_t count = CountComponents(variables, first, endings);
      if (count > field.count)
      {
        field.count = count;
        field.name = variables[first].substr(0, variables[first].size() - endings[0].size());
      }
    }
    while (std::ranges::find(fields, field.name, &ExodusField::name) != fields.end())
    {
      field.name += "_";
    }
    fields.push_back(std::move(field));
  }
  return fields;
}
} // namespace pixelexact
