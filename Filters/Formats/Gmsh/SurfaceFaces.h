// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/MeshFile.h"
#include "Formats/SolverModel.h"

namespace pixelexact::gmsh
{
/// The faces of elements that are elements of surfaces, too. `strangers`: how many of these are no
/// face of an element.
std::vector<BoundaryFace> FindFaces(const MeshFile& mesh, bool byEntity, std::size_t& strangers);
} // namespace pixelexact::gmsh
