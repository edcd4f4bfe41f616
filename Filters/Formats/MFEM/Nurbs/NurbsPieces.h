// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Nurbs/NurbsSpace.h"

#include <span>
#include <string>
#include <vector>

// Parallel NURBS meshes of MFEM. Each process' files contain some of the elements, and values of
// their control points only, in the order of the whole mesh's numbers.
namespace pixelexact::mfem
{
/// The mesh of all pieces, as ReadNurbs left them; its nodes stay with the pieces. Each piece's
/// file gets its elements, with vertices as its process numbers them. Throws InvalidData, naming
/// the piece, where they are not all pieces of one mesh.
MeshFile JoinNurbs(std::span<MeshPiece> pieces);

/// A NURBS grid function of all pieces.
struct PiecedFunction
{
  NurbsSpace space;
  std::vector<double> values;           ///< piece after piece, `components` for each control point
  std::vector<std::vector<int>> points; ///< per piece, of the whole mesh's control points
  std::vector<std::size_t> first;       ///< per piece: its first control point's row in `values`
  bool isOne = true;                    ///< pieces have equal values at common control points
};

/// Throws InvalidData and Unsupported, naming the piece.
PiecedFunction ReadPieces(const NurbsMesh& mesh, std::span<const GridFunctionFile> files,
  std::span<const std::string> names);
} // namespace pixelexact::mfem
