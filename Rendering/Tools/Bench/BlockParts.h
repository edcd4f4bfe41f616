// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"

#include <vector>

namespace pixelexact
{
/// The elements of one shape into which a cell of a generated mesh's lattice is divided, and their
/// maps.
class BlockParts
{
public:
  /// `curved`: maps of order 3, else of order 1 (see BlockKind).
  BlockParts(Shape shape, bool curved);

  [[nodiscard]] int PerCell() const { return static_cast<int>(OfCube.size()); }
  /// The change of basis from SourceValues to the coefficients of the map.
  [[nodiscard]] const ChangeOfBasis& ToModes() const { return Basis; }

  /// The map's values at the sources of element `part` in the lattice cell at `at`; the lattice has
  /// `side` cells along each side.
  [[nodiscard]] std::vector<Vec3> SourceValues(int part, const Vec3& at, int side) const;

private:
  Shape shape_;
  bool Curved;
  std::vector<std::vector<Vec3>> OfCube; ///< corners
  ChangeOfBasis Basis;
};
} // namespace pixelexact
