// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshDiagnostics_h
#define MeshDiagnostics_h

#include "Conversion/SourceMesh.h"
#include "Core/Element/Mesh.h"

#include <string>
#include <vector>

// Signs that a file does not mean what VTK's conventions make of it. All of it is judged from
// samples: a warning is a strong hint, silence proves nothing.
namespace pixelexact
{
/// Lines about the nodes' order and places; none where nothing is conspicuous.
///
/// - Lagrange wedges whose nodes inside the quadrilateral r = 0 seem to be mirrored (MFEM's way),
///   because mirroring them back makes most of the wedges much smoother; or not mirrored, where
///   they are taken as such.
/// - Lagrange cells whose nodes on straight edges stand at Gauss-Lobatto-Legendre points (DOLFINx's
///   default above order 2), where they are taken for equispaced, or the other way round.
std::vector<std::string> DiagnoseNodes(const SourceMesh& source);

/// Lines about elements whose Jacobian determinant vanishes or changes sign at sampled points, or
/// has the other sign than in most elements of its shape. Parallel.
std::vector<std::string> DiagnoseJacobian(
  const Mesh& mesh, std::span<const std::int64_t> sourceCells);
} // namespace pixelexact
#endif
