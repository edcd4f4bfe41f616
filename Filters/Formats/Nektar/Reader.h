// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <string_view>

namespace pixelexact::nektar
{
/// A file's content with the name that messages give it.
struct NamedText
{
  std::string name;
  std::string_view text; ///< kept alive by the caller
};

/// A Nektar++ mesh from the session files' GEOMETRY, with the fields of the parts of one field
/// file. Several files with a GEOMETRY are the parts of one mesh; the others may hold the rest of
/// the session. Throws InvalidData or Unsupported: "<file>, <tag> <id>: what; remedy".
SolverModel Read(const std::vector<NamedText>& sessions, const std::vector<NamedText>& fieldParts);
} // namespace pixelexact::nektar
