// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CgnsFile.h"

#include <map>

namespace pixelexact
{
/// The elements of an unstructured zone, as far as its boundary conditions need them.
struct CgnsSections
{
  std::set<std::string> types; ///< the names of all, "HEXA_27"
  /// Those that may be sides of others, by their numbers.
  std::map<std::int64_t, CgnsBoundary::Face> sides;
};

enum class CgnsAnswer : std::uint8_t
{
  Sound,
  Contradictory, ///< numbers that the zone does not have
  Failed         ///< the library could not read it
};

/// Of a zone of the library's open file, with so many points.
CgnsAnswer ReadCgnsSections(
  int file, int base, int zone, std::int64_t points, bool wantSides, CgnsSections& sections);
} // namespace pixelexact
