// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"
#include "Formats/MFEM/Meshes/Topology.h"

#include <span>
#include <vector>

namespace pixelexact::mfem
{
/// Assigns the unknowns of a grid function to elements, in the order of MFEM's FiniteElementSpace:
/// those of all vertices, then of all edges, of all faces, of all interiors.
class FunctionSpace
{
public:
  /// Views: mesh, topology and collection outlive it.
  FunctionSpace(const MeshFile& mesh, const Topology& topology, const Collection& collection);

  /// Unknowns of one component. 64 bits: orders and elements in a damaged file multiply.
  [[nodiscard]] std::int64_t Size() const { return Unknowns; }

  /// Writes an element's coefficients, component by component, in the order of its basis. `values`
  /// has `components` times Size() entries.
  void Gather(std::size_t element, std::span<const double> values, int components, bool byNodes,
    std::span<double> source) const;

private:
  class Writer;
  void GatherComponent(std::size_t element, Writer& writer) const;

  const MeshFile& Mesh;
  const Topology& Entities;
  const Collection& Functions;
  std::int64_t FirstEdgeUnknown = 0;
  std::vector<std::int64_t> FirstFaceUnknown;     ///< per face; empty where faces have none
  std::vector<std::int64_t> FirstInteriorUnknown; ///< per element
  std::int64_t Unknowns = 0;
};
} // namespace pixelexact::mfem
