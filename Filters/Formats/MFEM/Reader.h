// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/SolverModel.h"

namespace pixelexact::mfem
{
/// An MFEM mesh (v1.0 to v1.3, NC v1.0 to v1.1) with grid functions on it. A field is named after
/// its file, without folder and suffix. Throws InvalidData or Unsupported: "<file>, line <n>: what;
/// remedy".
SolverModel Read(const NamedText& mesh, const std::vector<NamedText>& gridFunctions);

/// The same from files, with at most one file's text in memory. A file "x.000000" with others
/// beside it ("x.000001", ...) is a piece of a parallel mesh: all pieces are read as one mesh,
/// elements one after another, and the same number of files of grid functions ("u.000000"). Throws
/// InvalidData, naming the file, where a piece is missing. `part` selects some of several pieces
/// (SolverModel::pieces); whether all belong to one run is then not checked. A file that is not a
/// piece is read whole.
SolverModel ReadFiles(
  const std::string& mesh, const std::vector<std::string>& gridFunctions, const PieceOf& part = {});

/// A GLVis stream: keyword, mesh, grid function (named `solution`), commands; or those of all
/// processes of a parallel run, each with "parallel n i" before it. Throws as Read, also where
/// several streams follow each other.
SolverModel ReadStream(const NamedText& saved);

/// Whether a file that begins so is a stream, by its first word.
bool IsStream(std::string_view head);
} // namespace pixelexact::mfem
