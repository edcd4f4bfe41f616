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

/// The same from files, one after the other: no more than one file's text is in memory at a time.
/// A file "x.000000" that has others beside it ("x.000001", ...) is a piece of a parallel mesh: all
/// of them are read as one, elements one after another, and of grid functions as many ("u.000000").
/// Throws InvalidData, naming the file, where a piece is missing. Of several pieces, those of the
/// part (SolverModel::pieces); whether all are of one run is then not looked at. What is no piece
/// is read whole.
SolverModel ReadFiles(
  const std::string& mesh, const std::vector<std::string>& gridFunctions, const PieceOf& part = {});

/// A GLVis stream: keyword, mesh, grid function (named `solution`), commands; or those of all
/// processes of a parallel run, each with "parallel n i" before it. Throws as Read, also where
/// several streams follow each other.
SolverModel ReadStream(const NamedText& saved);

/// Whether a file that begins so is a stream, by its first word.
bool IsStream(std::string_view head);
} // namespace pixelexact::mfem
