// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

// File names of the processes of a parallel run: "mesh.000000", "mesh.000001", ...
namespace pixelexact::mfem
{
/// Whether a file's name ends as MFEM writes a process' number: a dot and six digits.
bool IsPieceName(const std::string& path);

/// The files of all pieces of a mesh, in their order, where its name is that of a piece and other
/// pieces are in its folder; the file itself otherwise. Throws InvalidData, naming the file, where
/// one is missing between them.
std::vector<std::string> PiecesOf(const std::string& mesh);

/// The files of a grid function on a mesh of `pieces` pieces. Throws InvalidData, naming the file,
/// where one is missing or the name is not that of a piece.
std::vector<std::string> PiecesOf(
  const std::string& gridFunction, int pieces, const std::string& mesh);

/// The name of a field: "u" for "results/u.gf", "u.gf.gz" and "u.000000".
std::string FieldName(const std::string& path);
} // namespace pixelexact::mfem
