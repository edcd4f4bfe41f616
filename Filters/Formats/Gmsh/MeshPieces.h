// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Reader.h"

#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

// Meshes that Gmsh wrote as one file for each partition (Mesh.PartitionSplitMeshFiles): NAME_1.msh,
// NAME_2.msh, ... Tags of nodes and elements are those of the whole mesh.
namespace pixelexact::gmsh
{
/// The partitions that a file names.
struct Partitions
{
  std::size_t all = 0; ///< number of partitions of the mesh; 0: not in the file (version 2.2)
  std::set<int> here;
};

/// The files of all partitions of the mesh that `path` is a part of, in their order. `path` alone
/// where it is not a part: its name has no number, it holds the whole mesh, or its only partition
/// has another number than its name. Version 2.2 does not give the number of partitions: there a
/// second file must hold the partition of its own number. Throws InvalidData, naming the file,
/// where one is missing.
std::vector<std::string> PiecesOf(const std::string& path);

/// Joins the pieces of a mesh. Nodes that are in several pieces become one.
class MeshUnion
{
public:
  /// Throws InvalidData where a node has another position in another piece, or the dimensions
  /// differ.
  void Add(MeshFile&& piece, const std::string& name);
  /// Throws InvalidData where an element occurs twice.
  MeshFile Finish();

private:
  MeshFile Whole;
  std::unordered_map<std::uint64_t, std::int32_t> NodeOf; ///< by tag
  /// Corners, ascending, and the groups of each face. Both sides store a face between partitions.
  std::set<std::pair<std::array<std::int32_t, 4>, std::pair<std::int32_t, std::int32_t>>> Faces;
  bool HasPiece = false;
};
} // namespace pixelexact::gmsh
