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
  std::size_t begin = 0; ///< after the line `$Nodes`
};

/// The sections of a mesh's files (one, or one for each partition) and of files of views. Heads of
/// views are read at construction, values later.
class FileSet
{
public:
  /// The first `pieces` files hold the mesh.
  explicit FileSet(const std::vector<NamedText>& files, std::size_t pieces = 1);

  /// The solids or, where there are none or with `surfaces`, the surface elements.
  [[nodiscard]] MeshFile ReadMesh(bool surfaces = false);
  /// Reads the partitions that the first file names.
  [[nodiscard]] Partitions ReadPartitions();

  ViewList Views;
  std::vector<Scanner> Scanners; ///< per file
  std::vector<std::string> Notes;

private:
  void ReadViews(std::size_t file);
  void Pass(const Section& section, std::size_t file);
  MeshFile ReadPiece(std::size_t file, bool surfaces = false);

  std::size_t Pieces;

  std::vector<std::vector<Section>> Sections; ///< per file
};
} // namespace pixelexact::gmsh
