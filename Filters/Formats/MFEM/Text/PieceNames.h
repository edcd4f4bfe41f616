// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

// What processes of a parallel run name their files: "mesh.000000", "mesh.000001", ...
namespace pixelexact::mfem
{
/// Whether a file's name ends with a process' number, as MFEM writes it: a dot and six digits.
bool IsPieceName(const std::string& path);

/// The files of all pieces, in their order, of a mesh that is one by its name and has others
/// beside it; the file itself otherwise. Throws InvalidData, naming the file, where one is missing
/// between them.
std::vector<std::string> PiecesOf(const std::string& mesh);

/// Those of a grid function on a mesh of so many pieces. Throws InvalidData, naming the file, where
/// one is missing or the name is none of a piece.
std::vector<std::string> PiecesOf(
  const std::string& gridFunction, int pieces, const std::string& mesh);

/// "u" of "results/u.gf", of "u.gf.gz" and of "u.000000".
std::string FieldName(const std::string& path);
} // namespace pixelexact::mfem
