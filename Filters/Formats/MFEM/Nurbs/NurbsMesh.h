// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/KnotVector.h"
#include "Formats/MFEM/Nurbs/PatchNumbering.h"

namespace pixelexact::mfem
{
/// MFEM's own limit of indices.
inline constexpr std::int64_t kMaxControlPoints = 1 << 30;
/// Limit of control points that become one where boundaries are identified in all directions.
inline constexpr std::int64_t kMaxIdentified = 8;

/// The contents of a NURBS mesh's file except its nodes.
struct NurbsMesh
{
  PatchTopology topology;
  std::vector<KnotVector> vectors; ///< of topology.vectors
  std::vector<int> masters;        ///< attributes of boundaries, each identified with ...
  std::vector<int> slaves;         ///< ... that of the other list
  std::vector<double> weights;     ///< per control point; empty: all are 1
  std::vector<GridPlace> places;   ///< of the elements, which are the knot vectors' spans
  /// The elements of each process' piece, ascending. Empty: one file holds all of them.
  std::vector<std::vector<int>> pieces;
};

/// Reads what follows "MFEM NURBS mesh v1.0", or v1.1 (`hasSpacing`): patches, or knot vectors,
/// weights and nodes. Skips spacings, which only control refinement. A piece of a parallel mesh
/// (mesh_elements) has all patches and knot vectors, but weights and nodes of its own control
/// points only; its result has neither elements nor vertices. Throws InvalidData and Unsupported.
MeshFile ReadNurbs(TextScanner& scanner, bool hasSpacing);

/// Creates the elements and vertices of a mesh whose knot vectors are known; fills `nurbs.places`.
MeshFile MakeNurbsMesh(NurbsMesh& nurbs);
} // namespace pixelexact::mfem
