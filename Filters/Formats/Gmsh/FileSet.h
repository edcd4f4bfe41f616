// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshPieces.h"
#include "Formats/Gmsh/Reader.h"
#include "Formats/Gmsh/Views.h"

namespace pixelexact::gmsh
{
struct Section
{
  std::string name;      ///< "Nodes"
  std::size_t begin = 0; ///< behind the line `$Nodes`
};

/// A file of a mesh, or several of its partitions, and more of views, by sections: heads of views
/// are read, values not yet.
class FileSet
{
public:
  /// The first `pieces` files hold the mesh.
  explicit FileSet(const std::vector<NamedText>& files, std::size_t pieces = 1);

  [[nodiscard]] MeshFile ReadMesh();
  /// Of the first file.
  [[nodiscard]] Partitions ReadPartitions();

  ViewList Views;
  std::vector<Scanner> Scanners; ///< per file
  std::vector<std::string> Notes;

private:
  void ReadViews(std::size_t file);
  void Pass(const Section& section, std::size_t file);
  MeshFile ReadPiece(std::size_t file);

  std::size_t Pieces;

  std::vector<std::vector<Section>> Sections; ///< per file
};
} // namespace pixelexact::gmsh
