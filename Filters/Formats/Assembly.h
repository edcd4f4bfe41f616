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
SolverExpansion AssembleField(
  std::span<const ElementBasis* const> basis, int components, const Gather& gather);

/// Puts map, centre, size and uncertainty into `mesh`. The bases are scalar and sum to one (nodal
/// or Bernstein). `describe(e)` names an element in messages. Throws InvalidData for coordinates
/// that are not finite.
void AssembleMap(std::span<const ElementBasis* const> basis, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh);
} // namespace pixelexact
