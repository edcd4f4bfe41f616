// SPDX-License-Identifier: BSD-3-Clause
// Names and meanings are those of VTK's "VTKHDF format specification" (docs.vtk.org, versions 1.0
// to 2.5).
#include "Formats/VtkHdf/VtkHdfFile.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr const char* kRoot = "/VTKHDF";
constexpr const char* kGridType = "UnstructuredGrid";
constexpr std::uint64_t kMaxRows = std::numeric_limits<std::int64_t>::max() / 64;

[[noreturn]] void Damaged(const std::string& path, const std::string& why)
{
  throw InvalidData(path + ": " + why + "; the file is damaged: write or copy it again");
}

/// A text without the blanks and the quotes with which programs pad it.
std::string Unpadded(const std::string& text)
{
  const auto end = text.find_last_not_of(" \t\n");
  return end == std::string::npos ? std::string() : text.substr(0, end + 1);
}

bool IsCollection(const std::string& type)
{
  return type == "PartitionedDataSetCollection" || type == "MultiBlockDataSet";
}

/// Adds to a running place without overflow.
std::uint64_t Advanced(std::uint64_t place, std::uint64_t count, const std::string& path)
{
  if (place > kMaxRows || count > kMaxRows)
  {
    Damaged(path, "a count is out of range");
  }
  return place + count;
}
} // namespace

VtkHdfFile::VtkHdfFile(const std::string& path)
  : Opened(OpenHdf5(path))
{
  if (Opened->KindOf(kRoot) != Hdf5Kind::Group)
  {
    throw InvalidData(
      "it has no group VTKHDF, so it is an HDF5 file of another program; name a .vtkhdf file");
  }
  const auto version = Opened->HasAttribute(kRoot, "Version")
    ? Opened->IntegerAttributes(kRoot, "Version")
    : std::vector<std::int64_t>();
  if (!version.empty() && version[0] > 2)
  {
    throw Unsupported("it has version " + std::to_string(version[0]) +
      " of the format VTKHDF; versions 1 and 2 are read: write it as .vtu");
  }
  AddBlocks();
}

std::string VtkHdfFile::TypeOf(const std::string& root) const
{
  if (!Opened->HasAttribute(root, "Type"))
  {
    return {};
  }
  const auto texts = Opened->TextAttributes(root, "Type");
  return texts.empty() ? std::string() : Unpadded(texts.front());
}

void VtkHdfFile::AddBlocks()
{
  const std::string type = TypeOf(kRoot);
  if (type == kGridType)
  {
    AddBlock(kRoot);
    return;
  }
  if (!IsCollection(type))
  {
    throw Unsupported(
      (type.empty() ? std::string("it has no attribute Type") : "it holds data of type " + type) +
      "; an UnstructuredGrid is read: in ParaView, apply Append Datasets and save that as .vtu or "
      ".vtkhdf");
  }
  std::vector<std::pair<std::int64_t, std::string>> order;
  for (const std::string& name : Opened->Names(kRoot))
  {
    const std::string root = std::string(kRoot) + "/" + name;
    if (name == "Assembly" || Opened->KindOf(root) != Hdf5Kind::Group)
    {
      continue;
    }
    const auto index = Opened->HasAttribute(root, "Index")
      ? Opened->IntegerAttributes(root, "Index")
      : std::vector<std::int64_t>();
    order.emplace_back(index.empty() ? kMaxRows : index[0], name);
  }
  std::ranges::sort(order);
  for (const auto& [index, name] : order)
  {
    const std::string root = std::string(kRoot) + "/" + name;
    const std::string own = TypeOf(root);
    if (own == kGridType)
    {
      AddBlock(root);
    }
    else if (!own.empty())
    {
      Noted.emplace_back("the block '")
        .append(name)
        .append("' is of type ")
        .append(own)
        .append(" and is left out.");
    }
  }
  if (Blocks.empty())
  {
    throw Unsupported("its " + type +
      " has no block of type UnstructuredGrid; in ParaView, apply Append Datasets and save that as "
      ".vtu or .vtkhdf");
  }
}

void VtkHdfFile::AddBlock(const std::string& root)
{
  const std::vector<double> times = TimesOf(root);
  if (!Blocks.empty() && times != TimeOf)
  {
    throw Unsupported("its blocks have different time steps; write a file for each block");
  }
  TimeOf = times;
  Blocks.push_back({ root, times.size() });
}

std::vector<double> VtkHdfFile::TimesOf(const std::string& root) const
{
  const std::string steps = root + "/Steps";
  if (!Opened->Has(steps))
  {
    return {};
  }
  const auto count = Opened->IntegerAttributes(steps, "NSteps");
  std::vector<double> times;
  if (Opened->KindOf(steps + "/Values") == Hdf5Kind::Reals)
  {
    times = Opened->Reals(steps + "/Values");
  }
  else
  {
    const auto values = Opened->Integers(steps + "/Values");
    times.assign(values.begin(), values.end());
  }
  if (count.empty() || count[0] < 1 || static_cast<std::uint64_t>(count[0]) > times.size())
  {
    Damaged(steps, "NSteps is not a number of steps in Values");
  }
  // A run that is still going on, or was ended, may have written a time and not its step.
  times.resize(static_cast<std::size_t>(count[0]));
  if (!std::ranges::all_of(times, [](double time) { return std::isfinite(time); }))
  {
    Damaged(steps + "/Values", "a time is not finite");
  }
  return times;
}

std::vector<std::uint64_t> VtkHdfFile::Counts(const std::string& path) const
{
  if (Opened->KindOf(path) == Hdf5Kind::Unsigned)
  {
    return Opened->Unsigned(path);
  }
  const std::vector<std::int64_t> numbers = Opened->Integers(path);
  if (std::ranges::any_of(numbers, [](std::int64_t number) { return number < 0; }))
  {
    Damaged(path, "a count is negative");
  }
  return { numbers.begin(), numbers.end() };
}

/// The first number of a row; none: there is no such data set.
std::optional<std::uint64_t> VtkHdfFile::AtStep(const std::string& path, std::size_t step) const
{
  if (!Opened->Has(path))
  {
    return std::nullopt;
  }
  const auto row = Numbers(path, { step, 1 });
  if (row.empty() || row[0] < 0)
  {
    Damaged(path, "a number is negative or missing");
  }
  return static_cast<std::uint64_t>(row[0]);
}

std::vector<std::int64_t> VtkHdfFile::Numbers(const std::string& path, const Hdf5Rows& rows) const
{
  if (Opened->KindOf(path) != Hdf5Kind::Unsigned)
  {
    return Opened->Integers(path, rows);
  }
  const std::vector<std::uint64_t> numbers = Opened->Unsigned(path, rows);
  if (std::ranges::any_of(numbers, [](std::uint64_t number) { return number > kMaxRows; }))
  {
    Damaged(path, "a number is out of range");
  }
  return { numbers.begin(), numbers.end() };
}

std::vector<VtkHdfPart> VtkHdfFile::Parts(std::size_t block, std::size_t step) const
{
  const auto& [root, steps] = Blocks[block];
  const auto points = Counts(root + "/NumberOfPoints");
  const auto cells = Counts(root + "/NumberOfCells");
  const auto ids = Counts(root + "/NumberOfConnectivityIds");
  if (points.size() != cells.size() || points.size() != ids.size() || points.empty())
  {
    Damaged(root, "its counts of points, cells and connectivity ids are of different parts");
  }
  std::uint64_t first = 0;
  std::uint64_t count = points.size();
  VtkHdfPart next;
  if (steps > 0)
  {
    const std::string of = root + "/Steps/";
    const auto at = [&](const char* name) { return AtStep(of + name, step).value_or(0); };
    first = at("PartOffsets");
    // Without numbers of parts, steps share all of them or have equally many of their own.
    const std::uint64_t ofOne = steps > 1
      ? AtStep(of + "PartOffsets", 1).value_or(0) - AtStep(of + "PartOffsets", 0).value_or(0)
      : 0;
    count = AtStep(of + "NumberOfParts", step).value_or(ofOne > 0 ? ofOne : count);
    next.points.first = at("PointOffsets");
    next.cells.first = at("CellOffsets");
    next.connectivity.first = at("ConnectivityIdOffsets");
  }
  if (first > points.size() || count > points.size() - first)
  {
    Damaged(root + "/Steps", "step " + std::to_string(step) + " has parts that do not exist");
  }
  std::vector<VtkHdfPart> parts;
  parts.reserve(count);
  for (std::uint64_t i = first; i < first + count; ++i)
  {
    VtkHdfPart part = next;
    part.points.count = points[i];
    part.cells.count = cells[i];
    part.connectivity.count = ids[i];
    // Each part before has one offset more than cells.
    part.offsets = { Advanced(part.cells.first, i, root), Advanced(cells[i], 1, root) };
    next.points.first = Advanced(part.points.first, points[i], root);
    next.cells.first = Advanced(part.cells.first, cells[i], root);
    next.connectivity.first = Advanced(part.connectivity.first, ids[i], root);
    parts.push_back(part);
  }
  return parts;
}

std::vector<double> VtkHdfFile::Points(std::size_t block, const VtkHdfPart& part) const
{
  const std::string path = Blocks[block].root + "/Points";
  const std::vector<std::size_t> shape = Opened->Shape(path);
  if (shape.size() != 2 || shape[1] != 3)
  {
    Damaged(path, "its rows are not x, y and z");
  }
  return Opened->Reals(path, part.points);
}

bool VtkHdfFile::HasSinglePoints(std::size_t block) const
{
  return Opened->BytesOfValue(Blocks[block].root + "/Points") <= sizeof(float);
}

std::vector<std::uint64_t> VtkHdfFile::Types(std::size_t block, const Hdf5Rows& cells) const
{
  const std::string path = Blocks[block].root + "/Types";
  std::vector<std::uint64_t> types = Opened->Unsigned(path, cells);
  if (types.size() != cells.count ||
    std::ranges::any_of(
      types, [](std::uint64_t type) { return type > std::numeric_limits<std::uint8_t>::max(); }))
  {
    Damaged(path, "a cell has no type");
  }
  return types;
}

std::vector<std::int64_t> VtkHdfFile::Offsets(std::size_t block, const VtkHdfPart& part) const
{
  const std::string path = Blocks[block].root + "/Offsets";
  std::vector<std::int64_t> offsets = Numbers(path, part.offsets);
  if (offsets.size() != part.offsets.count || offsets.front() != 0 ||
    !std::ranges::is_sorted(offsets) ||
    static_cast<std::uint64_t>(offsets.back()) != part.connectivity.count)
  {
    Damaged(path, "the offsets of a part do not ascend from 0 to its number of connectivity ids");
  }
  return offsets;
}

std::vector<std::int64_t> VtkHdfFile::Connectivity(std::size_t block, const VtkHdfPart& part) const
{
  const std::string path = Blocks[block].root + "/Connectivity";
  std::vector<std::int64_t> points = Numbers(path, part.connectivity);
  const auto count = static_cast<std::int64_t>(part.points.count);
  if (points.size() != part.connectivity.count ||
    std::ranges::any_of(
      points, [count](std::int64_t point) { return point < 0 || point >= count; }))
  {
    Damaged(path, "a cell has a point that its part lacks");
  }
  return points;
}

std::vector<VtkHdfArray> VtkHdfFile::Arrays(
  std::size_t block, const std::string& group, std::vector<std::string>& notes) const
{
  const std::string root = Blocks[block].root + "/" + group;
  std::vector<VtkHdfArray> arrays;
  if (!Opened->Has(root))
  {
    return arrays;
  }
  for (const std::string& name : Opened->Names(root))
  {
    VtkHdfArray array;
    array.name = name;
    array.path = std::string(root).append("/").append(name);
    array.kind = Opened->KindOf(array.path);
    const bool isText = array.kind == Hdf5Kind::Texts && group == "FieldData";
    if (!isText &&
      (array.kind == Hdf5Kind::Texts || array.kind == Hdf5Kind::Group ||
        array.kind == Hdf5Kind::Other))
    {
      notes.emplace_back("'").append(name).append("' in ").append(group).append(
        " has no numbers and is left out.");
      continue;
    }
    const std::vector<std::size_t> shape = Opened->Shape(array.path);
    if (shape.empty())
    {
      notes.emplace_back("'").append(name).append("' in ").append(group).append(
        " is a single value, not an array, and is left out.");
      continue;
    }
    for (std::size_t d = 1; d < shape.size(); ++d)
    {
      array.components *= std::min<std::size_t>(shape[d], kMaxRows);
      if (array.components > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      {
        Damaged(array.path, "it has too many components");
      }
    }
    array.bytes = Opened->BytesOfValue(array.path);
    if (Opened->HasAttribute(array.path, "Attribute"))
    {
      const auto texts = Opened->TextAttributes(array.path, "Attribute");
      array.attribute = texts.empty() ? std::string() : Unpadded(texts.front());
    }
    arrays.push_back(array);
  }
  // Files of earlier versions name the arrays in attributes of the group.
  for (const char* purpose :
    { "Scalars", "Vectors", "Normals", "TCoords", "Tensors", "GlobalIds", "PedigreeIds", "EdgeFlag",
      "Tangents", "RationalWeights", "HigherOrderDegrees", "ProcessIds" })
  {
    if (!Opened->HasAttribute(root, purpose))
    {
      continue;
    }
    const auto texts = Opened->TextAttributes(root, purpose);
    const auto array = texts.empty()
      ? arrays.end()
      : std::ranges::find(arrays, Unpadded(texts.front()), &VtkHdfArray::name);
    if (array != arrays.end() && array->attribute.empty())
    {
      array->attribute = purpose;
    }
  }
  return arrays;
}

std::size_t VtkHdfFile::FirstRow(std::size_t block, const std::string& group,
  const VtkHdfArray& array, std::size_t step, std::size_t first) const
{
  const auto& [root, steps] = Blocks[block];
  if (steps == 0)
  {
    return first;
  }
  const std::string of = root + "/Steps/";
  const auto own = AtStep(of + group + "Offsets/" + array.name, step);
  if (!own)
  {
    return first;
  }
  const auto geometry =
    AtStep(of + (group == "PointData" ? "PointOffsets" : "CellOffsets"), step).value_or(0);
  return Advanced(*own, first - geometry, array.path);
}

Hdf5Rows VtkHdfFile::FieldRows(std::size_t block, const VtkHdfArray& array, std::size_t step) const
{
  const auto& [root, steps] = Blocks[block];
  const std::size_t all = Opened->Shape(array.path).front();
  const std::string of = root + "/Steps/FieldData";
  const auto first = steps == 0 ? std::nullopt : AtStep(of + "Offsets/" + array.name, step);
  if (!first)
  {
    return steps > 1 && all == steps ? Hdf5Rows{ step, 1 } : Hdf5Rows{ 0, all };
  }
  Hdf5Rows rows{ *first, 1 };
  if (const std::string sizes = of + "Sizes/" + array.name; Opened->Has(sizes))
  {
    const auto size = Numbers(sizes, { step, 1 });
    if (size.size() < 2 || size[1] < 0)
    {
      Damaged(sizes, "a row is not components and tuples");
    }
    rows.count = static_cast<std::size_t>(size[1]);
  }
  return rows;
}
} // namespace pixelexact
