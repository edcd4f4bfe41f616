// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshFile.h"
#include "Formats/Gmsh/Reader.h"

#include <array>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

// Meshes that Gmsh has written as a file for each partition (Mesh.PartitionSplitMeshFiles):
// NAME_1.msh, NAME_2.msh, ... Tags of nodes and elements are those of the whole mesh.
namespace pixelexact::gmsh
{
/// What a file tells of the partitions of its mesh.
struct Partitions
{
  std::size_t all = 0; ///< 0: it does not tell (version 2.2)
  std::set<int> here;
};

/// The files of all partitions of the mesh that `path` is a part of, in their order; `path` alone
/// where it is none: its name has no number, it holds the whole mesh, or its only partition has
/// another number than its name. Version 2.2 does not give the number of partitions: there a second
/// file must hold the partition of its own number. Throws InvalidData, naming the file, where one
/// is missing.
std::vector<std::string> PiecesOf(const std::string& path);

/// Puts pieces together. Nodes that several of them have become one.
class MeshUnion
{
public:
  /// Throws InvalidData where a node is elsewhere in another piece, or the dimensions differ.
  void Add(MeshFile&& piece, const std::string& name);
  /// Throws InvalidData where an element is there twice.
  MeshFile Finish();

private:
  MeshFile Whole;
  std::unordered_map<std::uint64_t, std::int32_t> NodeOf; ///< by tag
  /// Corners, ascending, and where they belong: faces between partitions stand in both.
  std::set<std::pair<std::array<std::int32_t, 4>, std::pair<std::int32_t, std::int32_t>>> Faces;
  bool HasPiece = false;
};
} // namespace pixelexact::gmsh
