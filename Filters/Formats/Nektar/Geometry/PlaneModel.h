// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

#include <string>

namespace pixelexact::nektar
{
/// The mesh of a two-dimensional geometry, as a slab (bases-and-kernels.md). `name`: of its file,
/// for messages. Throws InvalidData where it has no elements, Unsupported where it is in no plane
/// z = const.
SolverModel MakePlaneModel(const Geometry& geometry, const std::string& name);
} // namespace pixelexact::nektar
