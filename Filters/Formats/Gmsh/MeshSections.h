// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Scanner.h"

// The sections of a mesh; the scanner stands behind their first line, and behind their end
// afterwards.
namespace pixelexact::gmsh
{
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
