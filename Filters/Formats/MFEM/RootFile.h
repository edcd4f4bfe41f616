// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Reader.h"

#include <string>
#include <vector>

namespace pixelexact::mfem
{
/// What a root file of MFEM's VisIt collections (.mfem_root, JSON) tells of one cycle. Paths are
/// relative to its folder, or not, as they stand.
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

/// The mesh and all grid functions of a cycle; quadrature functions are left out, with a note.
/// Throws as ReadFiles.
SolverModel ReadRootFile(const std::string& path, const PieceOf& part = {});
} // namespace pixelexact::mfem
