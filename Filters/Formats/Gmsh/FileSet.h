// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/Reader.h"
#include "Formats/Gmsh/Views.h"

namespace pixelexact::gmsh
{
/// A file of a mesh and more of views, by sections: heads of views are read, values not yet.
class FileSet
{
public:
  explicit FileSet(const std::vector<NamedText>& files);

  [[nodiscard]] MeshFile ReadMesh();

  ViewList Views;
  std::vector<Scanner> Scanners; ///< per file
  std::vector<std::string> Notes;

private:
  void ReadViews(std::size_t file);
  void Pass(const Section& section, std::size_t file);

  std::vector<std::vector<Section>> Sections; ///< per file
};
} // namespace pixelexact::gmsh
