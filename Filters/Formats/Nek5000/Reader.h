// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/FileText.h"
#include "Formats/SolverModel.h"

// Fields of Nek5000, nekRS and neko.
namespace pixelexact::nek5000
{
/// Reads the fields of a step, and the mesh of another one. `step`, `mesh`: all parts of these
/// steps, in their order; an empty `mesh` is not read. Elements are in the order of their numbers.
/// Elements in which a field is not finite get NaN, with a note. Throws InvalidData or Unsupported:
/// "<file>: what; remedy".
SolverModel Read(const std::vector<NamedText>& step, const std::vector<NamedText>& mesh);
} // namespace pixelexact::nek5000
