// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Gmsh/Scanner.h"

#include <string>
#include <vector>

namespace pixelexact::gmsh
{
/// The version of $MeshFormat whose sections have entities.
inline constexpr double kNew = 4.1;

struct Section
{
  std::string name;      ///< "Nodes"
  std::size_t begin = 0; ///< behind the line `$Nodes`
};

/// The sections of a file, in its order, without $MeshFormat, which sets the scanner's encoding.
/// Throws InvalidData for what is no Gmsh file, Unsupported for versions other than 2.0 to 2.2
/// and 4.1.
std::vector<Section> ListSections(Scanner& scanner);
} // namespace pixelexact::gmsh
