// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

#include <string>
#include <unordered_map>

namespace pixelexact::nektar
{
/// Elements' faces by the numbers that composites know them by; their attributes are still open.
using FaceOwners = std::unordered_multimap<std::int64_t, BoundaryFace>;

/// Turns a geometry's composites into groups and attributes of the model's elements, which are the
/// geometry's in its order. `name`: of the mesh, for notes.
void AddGroups(
  const Geometry& source, const FaceOwners& owners, const std::string& name, SolverModel& model);
} // namespace pixelexact::nektar
