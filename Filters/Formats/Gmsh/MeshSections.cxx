// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/MeshFile.h"

#include "Formats/Gmsh/Scanner.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <set>

namespace pixelexact::gmsh
{
namespace
{
constexpr double kNamesWithoutDimension = 2.0;
constexpr double kCountsPartitions = 2.2;
constexpr int kDimensions = 4;
constexpr std::size_t kMaxNodes = std::numeric_limits<std::int32_t>::max();

void RequireDimension(const Scanner& scanner, int dimension)
{
  if (dimension < 0 || dimension >= kDimensions)
  {
    scanner.Fail("an entity has the dimension " + std::to_string(dimension) + ".");
  }
}

/// Returns the magnitude of a number whose sign marks something else, such as a ghost.
int WithoutSign(const Scanner& scanner, int number)
{
  if (number == std::numeric_limits<int>::min())
  {
    scanner.Fail("the number " + std::to_string(number) +
      " of a partition or a physical group is not possible; the file is damaged.");
  }
  return std::abs(number);
}

void AddNode(Scanner& scanner, MeshFile& mesh)
{
  for (int d = 0; d < 3; ++d)
  {
    mesh.positions.push_back(scanner.Real("a node's coordinate"));
  }
}

void FinishNodes(const Scanner& scanner, MeshFile& mesh)
{
  mesh.nodes = mesh.positions.size() / 3;
  if (mesh.positions.size() / 3 > kMaxNodes)
  {
    scanner.FailUnsupported("meshes of more than 2147483647 nodes are not read.");
  }
  if (const auto* twice = mesh.nodeOf.Finish())
  {
    scanner.Fail("node " + std::to_string(*twice) + " is there twice.");
  }
}

void ReadOldNodes(Scanner& scanner, bool parametric, MeshFile& mesh)
{
  const std::size_t count = scanner.TextCount("the number of nodes", 8);
  scanner.EndLine();
  mesh.positions.reserve(3 * count);
  mesh.nodeOf.Reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.nodeOf.Add(
      static_cast<std::uint32_t>(scanner.Int("a node's number")), static_cast<std::int32_t>(i));
    AddNode(scanner, mesh);
    if (parametric)
    {
      // Reads the node's parameters on the curve or surface of the model; its position has been
      // read.
      const int dimension = scanner.Int("the dimension of a node's entity");
      RequireDimension(scanner, dimension);
      scanner.SkipInts(1);
      scanner.SkipReals(dimension == 1 || dimension == 2 ? static_cast<std::size_t>(dimension) : 0);
    }
  }
}

void ReadNewNodes(Scanner& scanner, MeshFile& mesh)
{
  const std::size_t blocks = scanner.Count("the number of blocks of nodes", 4);
  const std::size_t count = scanner.Count("the number of nodes", 4);
  scanner.SkipSizes(2); // least and largest tag
  mesh.positions.reserve(3 * count);
  mesh.nodeOf.Reserve(count);
  std::vector<std::uint64_t> tags;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const int dimension = scanner.Int("the dimension of a block of nodes");
    RequireDimension(scanner, dimension);
    scanner.SkipInts(1); // the entity's tag
    const bool parametric = scanner.Int("whether nodes are parametric") != 0;
    tags.resize(scanner.Count("the number of nodes in a block", 4));
    for (auto& tag : tags)
    {
      tag = scanner.Size("a node's tag");
    }
    for (const auto tag : tags)
    {
      mesh.nodeOf.Add(tag, static_cast<std::int32_t>(mesh.positions.size() / 3));
      AddNode(scanner, mesh);
      scanner.SkipReals(parametric ? static_cast<std::size_t>(dimension) : 0);
    }
  }
  if (mesh.positions.size() != 3 * count)
  {
    scanner.Fail("its blocks hold " + std::to_string(mesh.positions.size() / 3) +
      " nodes, but the section " + std::to_string(count) + ".");
  }
}

void ReadOldElements(Scanner& scanner, MeshFile& mesh)
{
  const std::size_t count = scanner.TextCount("the number of elements", 8);
  scanner.EndLine();
  ElementList list(mesh, count);
  std::vector<int> tags;
  std::set<int> named; // partitions, also those that have a ghost of an element
  std::size_t done = 0;
  while (done < count)
  {
    const bool binary = scanner.GetEncoding().binary;
    int number = binary ? 0 : scanner.Int("an element's number");
    const int type = scanner.Int("an element's type");
    // In binary files elements of one type share a header.
    const int together = binary ? scanner.Int("the number of elements that follow") : 1;
    const int tagCount = scanner.Int("the number of an element's tags");
    if (together < 1 || static_cast<std::size_t>(together) > count - done || tagCount < 0 ||
      static_cast<std::size_t>(tagCount) > scanner.Remaining())
    {
      scanner.Fail("a block of " + std::to_string(together) + " elements with " +
        std::to_string(tagCount) + " tags is not possible here; the file is damaged.");
    }
    for (int i = 0; i < together; ++i, ++done)
    {
      number = binary ? scanner.Int("an element's number") : number;
      tags.resize(static_cast<std::size_t>(tagCount));
      for (int& tag : tags)
      {
        tag = scanner.Int("an element's tag");
      }
      // The tags are physical group, entity, number of partitions, and these. A negative number is
      // a partition in which the element is a ghost. Before version 2.2 there is one partition,
      // without their number.
      const bool counts = scanner.GetEncoding().version >= kCountsPartitions;
      const auto partitions =
        counts && tags.size() > 3 && tags[2] > 0 ? static_cast<std::size_t>(tags[2]) : 0;
      if (partitions > 0)
      {
        mesh.partitionsHere.insert(tags[3]);
        const std::size_t end = std::min(tags.size(), 3 + partitions);
        std::transform(tags.begin() + 3, tags.begin() + static_cast<std::ptrdiff_t>(end),
          std::inserter(named, named.end()),
          [&scanner](int tag) { return WithoutSign(scanner, tag); });
      }
      else if (!counts && tags.size() == 3 && tags[2] > 0)
      {
        mesh.partitionsHere.insert(tags[2]);
        named.insert(tags[2]);
      }
      // Without a number of partitions a fourth tag is a partition.
      if (tags.size() > 3 + std::max(partitions, std::size_t{ counts ? 1U : 0U }))
      {
        scanner.FailUnsupported("element " + std::to_string(number) +
          " is a part of another one (cut by a level set or a border); only whole ones are read.");
      }
      const std::int32_t physical = tags.empty() ? 0 : tags[0];
      const std::vector<std::int32_t> groups{ physical };
      list.Add(scanner, type, static_cast<std::uint32_t>(number),
        { groups, tags.size() > 1 ? tags[1] : 0 });
    }
  }
  mesh.partitions = std::max(mesh.partitions, named.size());
}

void ReadNewElements(Scanner& scanner, const Entities& entities, MeshFile& mesh)
{
  static const Entity none;
  const std::size_t blocks = scanner.Count("the number of blocks of elements", 4);
  const std::size_t count = scanner.Count("the number of elements", 2);
  scanner.SkipSizes(2);
  ElementList list(mesh, count);
  std::size_t done = 0;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const int dimension = scanner.Int("the dimension of a block of elements");
    RequireDimension(scanner, dimension);
    const int tag = scanner.Int("the tag of a block's entity");
    const int type = scanner.Int("the type of a block's elements");
    const std::size_t inBlock = scanner.Count("the number of elements in a block", 2);
    const auto entity = entities.find({ dimension, tag });
    const Entity& groups = entity == entities.end() ? none : entity->second;
    for (std::size_t i = 0; i < inBlock; ++i, ++done)
    {
      const std::uint64_t number = scanner.Size("an element's tag");
      list.Add(scanner, type, number, { groups.physical, tag });
    }
  }
  if (done != count)
  {
    scanner.Fail("its blocks hold " + std::to_string(done) + " elements, but the section " +
      std::to_string(count) + ".");
  }
}
} // namespace

void ReadPhysicalNames(Scanner& scanner, MeshFile& mesh)
{
  const std::size_t count = scanner.TextCount("the number of physical names", 6);
  for (std::size_t i = 0; i < count; ++i)
  {
    PhysicalName name;
    // Version 2.0 has no dimension; some that write it give one all the same.
    name.tag = static_cast<int>(scanner.IntegerBeforeName("the dimension of a physical group"));
    if (scanner.GetEncoding().version > kNamesWithoutDimension || !scanner.Peek().starts_with('"'))
    {
      name.dimension = name.tag;
      RequireDimension(scanner, name.dimension);
      name.tag = static_cast<int>(scanner.IntegerBeforeName("the tag of a physical group"));
    }
    name.name = scanner.Quoted("the name of a physical group");
    mesh.names.push_back(std::move(name));
  }
  scanner.EndSection("PhysicalNames");
}

void ReadEntities(Scanner& scanner, bool partitioned, Entities& entities, MeshFile& mesh)
{
  if (partitioned)
  {
    mesh.partitions = scanner.Count("the number of partitions", 1);
    const std::size_t ghosts = scanner.Count("the number of ghost entities", 2);
    scanner.SkipInts(2 * ghosts);
  }
  std::array<std::size_t, kDimensions> counts{};
  for (auto& count : counts)
  {
    count = scanner.Count("the number of entities", 4);
  }
  for (int dimension = 0; dimension < kDimensions; ++dimension)
  {
    for (std::size_t i = 0; i < counts[dimension]; ++i)
    {
      Entity entity;
      const int tag = scanner.Int("an entity's tag");
      if (partitioned)
      {
        scanner.SkipInts(2); // the entity that it is a part of
        const std::size_t parts = scanner.Count("the number of an entity's partitions", 1);
        for (std::size_t k = 0; k < parts; ++k)
        {
          const int part = scanner.Int("a partition");
          if (dimension == (counts[3] > 0 ? 3 : 2))
          {
            mesh.partitionsHere.insert(part);
          }
        }
      }
      scanner.SkipReals(dimension == 0 ? 3 : 6); // its place or box
      const std::size_t groups = scanner.Count("the number of an entity's physical groups", 1);
      for (std::size_t k = 0; k < groups; ++k)
      {
        // A negative one has the entity reversed.
        entity.physical.push_back(WithoutSign(scanner, scanner.Int("a physical group")));
      }
      if (dimension > 0)
      {
        scanner.SkipInts(scanner.Count("the number of an entity's bounding entities", 1));
      }
      entities[{ dimension, tag }] = std::move(entity);
    }
  }
  scanner.EndSection(partitioned ? "PartitionedEntities" : "Entities");
}

void ReadNodes(Scanner& scanner, bool parametric, MeshFile& mesh)
{
  if (scanner.GetEncoding().version == kNew)
  {
    ReadNewNodes(scanner, mesh);
  }
  else
  {
    ReadOldNodes(scanner, parametric, mesh);
  }
  FinishNodes(scanner, mesh);
  scanner.EndSection(parametric ? "ParametricNodes" : "Nodes");
}

void ReadElements(Scanner& scanner, const Entities& entities, MeshFile& mesh)
{
  if (scanner.GetEncoding().version == kNew)
  {
    ReadNewElements(scanner, entities, mesh);
  }
  else
  {
    ReadOldElements(scanner, mesh);
  }
  if (const auto* twice = mesh.elementOf.Finish())
  {
    scanner.Fail("element " + std::to_string(*twice) + " is there twice.");
  }
  scanner.EndSection("Elements");
}
} // namespace pixelexact::gmsh
