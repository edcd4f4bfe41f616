// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Rounding.h"
#include "Formats/ElementBasis.h"
#include "Formats/SolverModel.h"

#include <functional>
#include <span>

// Changes the basis of all elements from a solver's coefficients to the canonical ones, in
// parallel.
namespace pixelexact
{
/// Writes the source coefficients of an element: `components` times basis.sources, component by
/// component (vector bases: basis.sources). Called from several threads at once.
using Gather = std::function<void(std::size_t element, std::span<double> source)>;

/// Assembles a field. `basis[e]` outlives the call; the bases of one field are all scalar or all
/// vector.
OwnedExpansion AssembleField(
  std::span<const ElementBasis* const> basis, int components, const Gather& gather);

/// Stores map, centre, size and uncertainty in `mesh`. The bases are scalar and sum to one (nodal
/// or Bernstein). `describe(e)` names an element in messages. `roundoff` is the unit roundoff of
/// the file's coordinates. Throws InvalidData for coordinates that are not finite.
void AssembleMap(std::span<const ElementBasis* const> basis, const Gather& gather,
  const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh,
  double roundoff = kUnitRoundoff);

/// The same for a plane mesh, whose bases have order 0 across: `mesh` becomes the slab on it, and
/// its `slab` holds the position. The source has two components, or three where the file has a z.
/// Where z is not constant, each element has its solid beneath it (LiftSurface).
void AssemblePlaneMap(std::span<const ElementBasis* const> basis, int components,
  const Gather& gather, const std::function<std::string(std::size_t)>& describe, SolverMesh& mesh,
  double roundoff = kUnitRoundoff);

/// Drops the trailing orders of maps that rounding of the coordinates explains (OrderReduction.h),
/// and counts the loss as uncertainty: for files whose maps have the fields' order in all elements.
/// `basis` and `roundoff` are those with which the map was assembled.
void DropRoundedOrders(
  std::span<const ElementBasis* const> basis, double roundoff, SolverMesh& mesh);

/// Scales fields of a slab, whose values are those of the plane: flux and density of a unit element
/// count per thickness. The scaling is exact. Throws Unsupported for mapped fields on a surface in
/// space.
void ScaleToSlab(const Slab& slab, SolverField& field);
} // namespace pixelexact
