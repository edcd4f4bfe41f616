// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <cstdint>
#include <string>

// Meshes of HOPR (x_mesh.h5), which FLEXI and other solvers use.
namespace pixelexact
{
class Hdf5File;
}
namespace pixelexact::flexi
{
/// Whether the file has the data sets of a mesh.
bool IsMesh(const Hdf5File& file);

/// The number of elements. Throws InvalidData.
std::int64_t CountElements(const Hdf5File& mesh);

/// Reads a mesh of curved hexahedra: maps, zones as attributes, boundary conditions as attributes
/// of faces. Throws InvalidData or Unsupported, with the file's name and the remedy.
SolverMesh ReadMesh(const Hdf5File& mesh, const std::string& name);
} // namespace pixelexact::flexi
