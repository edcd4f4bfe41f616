// SPDX-License-Identifier: BSD-3-Clause
#include "Input/ExodusFile.h"

#include "Input/Input.h"

#include <vtk_exodusII.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMostNodes = 1000; ///< of an element

std::string NameOf(int file, ex_entity_type type, std::int64_t id)
{
  std::array<char, MAX_STR_LENGTH + 1> name{};
  return ex_get_name(file, type, id, name.data()) >= 0 ? std::string(name.data()) : std::string();
}
} // namespace

ExodusFile::ExodusFile(const std::string& path)
  : Path(path)
{
  int computerWord = sizeof(double);
  int fileWord = 0;
  float version = 0.0F;
  ex_opts(0); // the library prints else
  Id = ex_open(path.c_str(), EX_READ, &computerWord, &fileWord, &version);
  if (Id < 0)
  {
    CannotRead(path, "it is no Exodus II file, or damaged");
  }
  ex_set_int64_status(Id, EX_ALL_INT64_API);
}

ExodusFile::~ExodusFile()
{
  ex_close(Id);
}

void ExodusFile::Require(bool sound) const
{
  if (!sound)
  {
    CannotRead(Path, "it is damaged or cut short; copy it anew");
  }
}

void ExodusFile::RequireConnectivity(
  std::int64_t block, std::int64_t count, std::int64_t points) const
{
  if (count == 0)
  {
    return;
  }
  std::vector<std::int64_t> nodes(static_cast<std::size_t>(count));
  Require(ex_get_conn(Id, EX_ELEM_BLOCK, block, nodes.data(), nullptr, nullptr) >= 0);
  Require(std::ranges::all_of(
    nodes, [points](std::int64_t node) { return node >= 1 && node <= points; }));
}

std::map<std::int64_t, ExodusFile::Block> ExodusFile::Blocks() const
{
  const std::int64_t count = ex_inquire_int(Id, EX_INQ_ELEM_BLK);
  const std::int64_t points = ex_inquire_int(Id, EX_INQ_NODES);
  Require(count >= 0 && count <= kMost && points >= 0 && points <= kMost);
  std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
  Require(ids.empty() || ex_get_ids(Id, EX_ELEM_BLOCK, ids.data()) >= 0);
  std::map<std::int64_t, Block> blocks;
  std::int64_t first = 1;
  for (const std::int64_t id : ids)
  {
    std::array<char, MAX_STR_LENGTH + 1> type{};
    std::int64_t elements = 0;
    std::int64_t nodes = 0;
    std::int64_t edges = 0;
    std::int64_t faces = 0;
    std::int64_t attributes = 0;
    const int got = ex_get_block(
      Id, EX_ELEM_BLOCK, id, type.data(), &elements, &nodes, &edges, &faces, &attributes);
    Require(got >= 0 && elements >= 0 && elements <= kMost && nodes >= 0 && nodes <= kMostNodes);
    std::string upper = type.data();
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
    if (upper.starts_with("BEX"))
    {
      // Their nodes are not the file's.
      CannotRead(Path,
        "block " + std::to_string(id) + " has elements of type " + upper +
          " (Bezier extraction), whose functions are splines; write the mesh with Lagrange "
          "elements");
    }
    RequireConnectivity(id, elements * nodes, points);
    if (elements > 0)
    {
      blocks[id] = { upper, static_cast<int>(nodes), NameOf(Id, EX_ELEM_BLOCK, id), first };
      first += elements;
    }
  }
  return blocks;
}

std::vector<ExodusFile::SideSet> ExodusFile::SideSets() const
{
  const std::int64_t count = ex_inquire_int(Id, EX_INQ_SIDE_SETS);
  const std::int64_t elements = ex_inquire_int(Id, EX_INQ_ELEM);
  Require(count >= 0 && count <= kMost && elements >= 0 && elements <= kMost);
  std::vector<std::int64_t> ids(static_cast<std::size_t>(count));
  Require(ids.empty() || ex_get_ids(Id, EX_SIDE_SET, ids.data()) >= 0);
  std::vector<SideSet> sets;
  for (const std::int64_t id : ids)
  {
    std::int64_t sides = 0;
    std::int64_t factors = 0;
    Require(ex_get_set_param(Id, EX_SIDE_SET, id, &sides, &factors) >= 0);
    Require(sides >= 0 && sides <= kMost);
    SideSet& set = sets.emplace_back();
    set.id = id;
    set.name = NameOf(Id, EX_SIDE_SET, id);
    set.elements.resize(static_cast<std::size_t>(sides));
    set.sides.resize(static_cast<std::size_t>(sides));
    Require(
      sides == 0 || ex_get_set(Id, EX_SIDE_SET, id, set.elements.data(), set.sides.data()) >= 0);
    Require(std::ranges::all_of(set.elements,
      [elements](std::int64_t element) { return element >= 1 && element <= elements; }));
  }
  return sets;
}

std::int64_t ExodusFile::Elements() const
{
  return std::max<std::int64_t>(ex_inquire_int(Id, EX_INQ_ELEM), 0);
}

std::vector<double> ExodusFile::Times() const
{
  const std::int64_t count = ex_inquire_int(Id, EX_INQ_TIME);
  Require(count >= 0 && count <= kMost);
  std::vector<double> times(static_cast<std::size_t>(count));
  Require(times.empty() || ex_get_all_times(Id, times.data()) >= 0);
  return times;
}

std::int64_t ExodusFile::NodeSets() const
{
  return std::max<std::int64_t>(ex_inquire_int(Id, EX_INQ_NODE_SETS), 0);
}
} // namespace pixelexact
