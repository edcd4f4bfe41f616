// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/ElementType.h"
#include "Formats/Gmsh/TagIndex.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

// The mesh of a Gmsh file, as plain structs.
namespace pixelexact::gmsh
{
/// An element of a volume or, where there is none, of a surface.
struct Solid
{
  const ElementType* type = nullptr;
  std::int64_t number = 0;   ///< the file's
  std::int32_t physical = 0; ///< the first of its physical groups, 0: none
  std::int32_t entity = 0;
  std::size_t firstNode = 0; ///< in MeshFile::elementNodes
};

/// An element of a dimension less, once for each of its physical groups.
struct SurfaceElement
{
  std::array<std::int32_t, 4> corners{ -1, -1, -1, -1 }; ///< nodes
  std::int32_t physical = 0;
  std::int32_t entity = 0;
};

/// Of names in files of version 2.0.
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
  std::vector<double> positions; ///< (x, y, z) of each node; let go when the map is made
  std::size_t nodes = 0;
  TagIndex nodeOf;
  std::vector<Solid> elements;
  std::vector<std::int32_t> elementNodes;
  TagIndex elementOf; ///< also the numbers under which an element is repeated
  std::vector<SurfaceElement> faces;
  std::size_t lower = 0; ///< elements of lower dimensions
  std::vector<PhysicalName> names;
  std::size_t inSeveralGroups = 0; ///< elements in more than one physical group
  std::size_t partitions = 1; ///< that the file names; the mesh was divided into as many at least
  std::set<int> partitionsHere;

  [[nodiscard]] std::span<const std::int32_t> NodesOf(const Solid& element) const
  {
    return { &elementNodes[element.firstNode], static_cast<std::size_t>(element.type->nodes) };
  }
};
} // namespace pixelexact::gmsh
