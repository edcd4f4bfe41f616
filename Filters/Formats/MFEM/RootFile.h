// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Reader.h"

#include <string>
#include <vector>

namespace pixelexact::mfem
{
/// One cycle in a root file of MFEM's VisIt collections (.mfem_root, JSON). Paths are as in the
/// file, absolute or relative to its folder.
struct RootFile
{
  struct Field
  {
    std::string name;
    std::string path; ///< of the first piece
  };
  int cycle = 0;
  double time = 0.0;
  int pieces = 1;
  std::string mesh; ///< path of the first piece
  std::vector<Field> fields;
};

/// Throws InvalidData, naming the file and the entry.
RootFile ParseRootFile(const NamedText& file);

/// Reads the mesh, all grid functions and quadrature functions of a cycle. Quadrature functions on
/// other shapes than quadrilaterals and hexahedra are left out, with a note. Throws as ReadFiles.
SolverModel ReadRootFile(const std::string& path, const PieceOf& part = {});
} // namespace pixelexact::mfem
