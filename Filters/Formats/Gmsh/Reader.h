// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/SolverModel.h"

namespace pixelexact::gmsh
{
/// The times of the steps of all views, ascending; empty where there is one step without a time.
/// Throws InvalidData or Unsupported: "<file>, line <n>: what; remedy".
std::vector<double> ReadTimes(const std::vector<NamedText>& files, std::size_t pieces = 1);

/// Reads the mesh of the first file, or of the first `pieces` files, which are its partitions
/// (MeshPieces.h), and the views of all files at a step (counted from 0). Further files contain
/// views only. Views become fields of their names; elements without values get NaN, with a note.
/// Without `wantMesh` the mesh is left empty. `surfaces`: the elements are the triangles and
/// quadrilaterals, also where the file has solids. Throws as ReadTimes.
SolverModel Read(const std::vector<NamedText>& files, int step = 0, bool wantMesh = true,
  std::size_t pieces = 1, bool surfaces = false);
} // namespace pixelexact::gmsh
