// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace pixelexact
{
/// Largest count in a file that is accepted.
inline constexpr std::int64_t kMaxCgnsCount = std::numeric_limits<std::int32_t>::max();

/// A boundary condition on a zone, in the zone's points, counted from 0.
struct CgnsBoundary
{
  /// The corners of a face of a solid, or of a plane element's edge; -1 where there are fewer.
  using Face = std::array<std::int64_t, 4>;

  std::string name; ///< the condition's own, or that of the family to which it refers
  std::vector<Face> faces;
  std::vector<std::int64_t> points; ///< where given by points: faces with all corners here
};

struct CgnsZone
{
  std::int64_t points = 0;
  bool isSingle = false;          ///< its coordinates have single precision
  std::set<std::string> elements; ///< the names of their types, "HEXA_27"
  std::vector<CgnsBoundary> boundaries;
  std::vector<std::string> left; ///< names of conditions that are not read, or contradict the zone
};

/// Reads a file's boundary conditions with the CGNS library: the zones of all bases, in their
/// order. Throws Error, naming the file, where the library cannot read it.
std::vector<CgnsZone> ReadCgnsZones(const std::string& file);
} // namespace pixelexact
