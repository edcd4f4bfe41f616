// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CgnsFile.h"

#include <map>

namespace pixelexact
{
/// The data of an unstructured zone's elements that its boundary conditions need.
struct CgnsSections
{
  std::set<std::string> types; ///< the names of all types, "HEXA_27"
  /// Elements that may be sides of others, by their numbers.
  std::map<std::int64_t, CgnsBoundary::Face> sides;
};

enum class CgnsAnswer : std::uint8_t
{
  Sound,
  Contradictory, ///< numbers that the zone does not have
  Failed         ///< the library could not read it
};

/// Reads the sections of a zone with `points` points in the library's open file.
CgnsAnswer ReadCgnsSections(
  int file, int base, int zone, std::int64_t points, bool wantSides, CgnsSections& sections);
} // namespace pixelexact
