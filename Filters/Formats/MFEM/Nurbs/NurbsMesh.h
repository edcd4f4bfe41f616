// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/KnotVector.h"
#include "Formats/MFEM/Nurbs/PatchNumbering.h"

namespace pixelexact::mfem
{
/// What a NURBS mesh's file holds beside its nodes.
struct NurbsMesh
{
  PatchTopology topology;
  std::vector<KnotVector> vectors; ///< of topology.vectors
  std::vector<int> masters;        ///< attributes of boundaries, each identified with ...
  std::vector<int> slaves;         ///< ... that of the other list
  std::vector<double> weights;     ///< per control point; empty: all are 1
  std::vector<GridPlace> places;   ///< of the elements, which are the knot vectors' spans
};

/// Reads what follows "MFEM NURBS mesh v1.0", or v1.1 (`hasSpacing`): by patches, or by knot
/// vectors, weights and nodes. Spacing, which only tells how to refine, is passed over. Throws
/// InvalidData and Unsupported.
MeshFile ReadNurbs(TextScanner& scanner, bool hasSpacing);
} // namespace pixelexact::mfem
