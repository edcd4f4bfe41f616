// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/ElementType.h"
#include "Formats/Gmsh/Scanner.h"
#include "Formats/SolverModel.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

// The mesh of a Gmsh file, as plain structs.

namespace pixelexact::gmsh
{
/// Maps the tags of nodes or elements, which may be sparse, to their places.
class TagIndex
{
public:
  void Reserve(std::size_t tags) { Pairs.reserve(tags); }
  void Add(std::uint64_t tag, std::int32_t place) { Pairs.emplace_back(tag, place); }
  /// Sorts the tags. Must be called once, after all have been added. Returns the first tag that was
  /// added twice, or null.
  [[nodiscard]] const std::uint64_t* Finish();
  /// Calls function(tag, place) for each tag, after Finish.
  template <class Function>
  void ForEach(Function&& function) const
  {
    for (const auto& [tag, place] : Pairs)
    {
      function(tag, place);
    }
    for (std::size_t i = 0; i < Dense.size(); ++i)
    {
      if (Dense[i] >= 0)
      {
        function(First + i, Dense[i]);
      }
    }
  }
  /// The place of a tag; -1 where it does not exist.
  [[nodiscard]] std::int32_t Find(std::uint64_t tag) const;

private:
  std::vector<std::pair<std::uint64_t, std::int32_t>> Pairs; ///< by tag
  std::vector<std::int32_t> Dense; ///< by tag - First, where few are missing
  std::uint64_t First = 0;
  std::uint64_t Twice = 0;
};

/// An element of a volume or, where there is none, of a surface.
struct Solid
{
  const ElementType* type = nullptr;
  std::int64_t number = 0;   ///< the file's
  std::int32_t physical = 0; ///< the first of its physical groups, 0: none
  std::int32_t entity = 0;
  std::size_t firstNode = 0; ///< in MeshFile::elementNodes
};

/// An element of one dimension less than the mesh, once for each of its physical groups.
struct SurfaceElement
{
  std::array<std::int32_t, 4> corners{ -1, -1, -1, -1 }; ///< nodes
  std::int32_t physical = 0;
  std::int32_t entity = 0;
};

/// The dimension of names in files of version 2.0, which give none.
inline constexpr int kAnyDimension = -1;

struct PhysicalName
{
  int dimension = kAnyDimension;
  int tag = 0;
  std::string name;
};

struct MeshFile
{
  int dimension = 3;             ///< of the elements, 3 or 2
  std::vector<double> positions; ///< (x, y, z) of each node; freed when the map is assembled
  std::size_t nodes = 0;
  TagIndex nodeOf;
  std::vector<Solid> elements;
  std::vector<std::int32_t> elementNodes;
  TagIndex elementOf; ///< also maps the other numbers under which an element is repeated
  std::vector<SurfaceElement> faces;
  std::size_t lower = 0; ///< elements of lower dimensions
  std::vector<PhysicalName> names;
  std::size_t inSeveralGroups = 0; ///< elements in more than one physical group
  std::size_t partitions = 1;      ///< number in the file; the mesh has at least as many
  std::set<int> partitionsHere;

  [[nodiscard]] std::span<const std::int32_t> NodesOf(const Solid& element) const
  {
    return { &elementNodes[element.firstNode], static_cast<std::size_t>(element.type->nodes) };
  }
};

/// The physical groups and the partition of an element.
struct Membership
{
  const std::vector<std::int32_t>& physical;
  std::int32_t entity;
};

/// Sorts a file's elements into those of volumes and of surfaces.
class ElementList
{
public:
  ElementList(MeshFile& mesh, std::size_t count);

  /// Reads an element's nodes. `number` is the file's.
  void Add(Scanner& scanner, int type, std::uint64_t number, const Membership& where);

private:
  void AddSolid(const ElementType& type, std::uint64_t number, const Membership& where);
  void AddSurface(const ElementType& type, const Membership& where);
  [[nodiscard]] bool RepeatsTheLast(const ElementType& type, const Membership& where) const;

  MeshFile& Mesh;
  std::vector<std::int32_t> Nodes; ///< of the element at hand
  std::int32_t Repeated = -1;      ///< the last element known to be in several groups
};

/// Finds the faces of elements that are also elements of surfaces. `strangers` gets the number of
/// surface elements that are not faces.
std::vector<BoundaryFace> FindFaces(const MeshFile& mesh, bool byEntity, std::size_t& strangers);

// Readers of a mesh's sections. The scanner is after the section's first line at the call and after
// its end on return.

/// Physical groups and partitions of an entity (version 4.1).
struct Entity
{
  std::vector<std::int32_t> physical;
};
using Entities = std::map<std::pair<int, int>, Entity>; ///< by dimension and tag

/// $PhysicalNames
void ReadPhysicalNames(Scanner& scanner, MeshFile& mesh);
/// $Entities and $PartitionedEntities (4.1)
void ReadEntities(Scanner& scanner, bool partitioned, Entities& entities, MeshFile& mesh);
/// $Nodes, and $ParametricNodes of version 2.2
void ReadNodes(Scanner& scanner, bool parametric, MeshFile& mesh);
/// $Elements; entities of version 4.1
void ReadElements(Scanner& scanner, const Entities& entities, MeshFile& mesh);
} // namespace pixelexact::gmsh
