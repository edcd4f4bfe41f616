// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CgnsFile.h"

#include <span>

namespace pixelexact
{
/// The points of a structured zone, of two or three directions, the first one fastest.
struct CgnsStructured
{
  int directions = 3;
  std::array<std::int64_t, 3> extent{ 1, 1, 1 };

  // Numbers are those of a condition: a point's place along each direction, from 1. False where
  // there is no such point, or no side.

  /// Adds points.
  bool AddPoints(std::span<const std::int64_t> numbers, CgnsBoundary& boundary) const;
  /// Adds the faces between two corners. `across`: the direction across which they are, and along
  /// the others the corners are numbers of cells; -1: the corners are points, and one direction is
  /// flat.
  bool AddFaces(std::span<const std::int64_t> numbers, int across, CgnsBoundary& boundary) const;
};
} // namespace pixelexact
