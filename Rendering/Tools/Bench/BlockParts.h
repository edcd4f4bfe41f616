// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"

#include <vector>

namespace pixelexact
{
/// The elements of one shape that a cell of a made mesh's lattice is cut into, and their maps.
class BlockParts
{
public:
  /// `curved`: maps of order 3, else of order 1 (see BlockKind).
  BlockParts(Shape shape, bool curved);

  [[nodiscard]] int PerCell() const { return static_cast<int>(OfCube.size()); }
  /// From the values below to the coefficients of the map.
  [[nodiscard]] const ChangeOfBasis& ToModes() const { return Basis; }

  /// What the map is in a part of the lattice's cell at `at`, of a lattice of `side` cells a side.
  [[nodiscard]] std::vector<Vec3> SourceValues(int part, const Vec3& at, int side) const;

private:
  Shape shape_;
  bool Curved;
  std::vector<std::vector<Vec3>> OfCube; ///< corners
  ChangeOfBasis Basis;
};
} // namespace pixelexact
