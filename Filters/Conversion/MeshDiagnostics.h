// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshDiagnostics_h
#define MeshDiagnostics_h

#include "Conversion/SourceMesh.h"
#include "Core/Element/Mesh.h"

#include <string>
#include <vector>

// Signs that a file does not follow VTK's conventions. All of them are found by sampling: a warning
// is a strong hint, its absence proves nothing.
namespace pixelexact
{
/// Lines about the nodes' order and places; none where nothing is conspicuous.
///
/// - Lagrange wedges whose nodes inside the quadrilateral r = 0 seem to be mirrored (MFEM's way),
///   because mirroring them back makes most of the wedges much smoother; or not mirrored, where
///   they are taken as such.
/// - Lagrange cells of order 3 and above whose nodes on edges, straight or curved, stand at
///   Gauss-Lobatto-Legendre points (DOLFINx's default above order 2) or Chebyshev points, where
///   they are taken for equispaced, or the other way round.
/// - What DiagnoseNodeOrder finds.
std::vector<std::string> DiagnoseNodes(const SourceMesh& source);

/// Adds lines about cells whose nodes on edges or faces fit other edges or faces, which indicates
/// another program's order of nodes. A line states the permutation and, where known, the program.
void DiagnoseNodeOrder(const SourceMesh& source, std::vector<std::string>& lines);

/// Lines about cells at the same place as others, which count twice; empty where there are none.
/// Parallel.
std::vector<std::string> DiagnoseSameCells(vtkUnstructuredGrid* grid);

/// Lines about elements whose Jacobian determinant vanishes or changes sign at sampled points, or
/// has the other sign than in most elements of its shape. `isPlane`: the mesh is a slab, whose
/// shapes are named as in the plane. Parallel.
std::vector<std::string> DiagnoseJacobian(
  const Mesh& mesh, std::span<const std::int64_t> sourceCells, bool isPlane);
} // namespace pixelexact
#endif
