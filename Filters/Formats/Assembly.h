// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/SolverModel.h"

#include <functional>
#include <span>

// From a solver's coefficients to canonical ones, for all elements, in parallel.
namespace pixelexact
{
/// Writes the source coefficients of an element: `components` times basis.sources, component by
/// component (vector bases: basis.sources). Called from several threads at once.
using Gather = std::function<void(std::size_t element, std::span<double> source)>;

/// A field. `basis[e]` outlives the call; bases of one field are all scalar or all vector.
OwnedExpansion AssembleField(
  std::span<const ElementBasis* const> basis, int components, const Gather& gather);

/// Puts map, centre, size and uncertainty into `mesh`. The bases are scalar and sum to one (nodal
/// or Bernstein). `describe(e)` names an element in messages. Throws InvalidData for coordinates
/// that are not finite.
void AssembleMap(std::span<const ElementBasis* const> basis, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh);

/// The same of a plane mesh, whose bases are of order 0 across: `mesh` becomes the slab on it, and
/// tells where that is. The source has two components, or three where the file has a z. Throws
/// Unsupported, naming the file, where that z is not one and the same.
void AssemblePlaneMap(std::span<const ElementBasis* const> basis, int components,
  const Gather& gather, const std::function<std::string(std::size_t)>& describe,
  const std::string& file, SolverMesh& mesh);

/// For fields of a slab, whose values are those of the plane: flux and density of a unit element
/// count per thickness. Exact.
void ScaleToSlab(const Slab& slab, SolverField& field);
} // namespace pixelexact
