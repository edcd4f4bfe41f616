// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Basis/Space.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// An upper bound of |mode (p, q, r)| on the shape.
double ModeBound(const Space& space, int p, int q, int r);
/// The sum of these bounds over all modes.
double SumOfModeBounds(const Space& space);

/// A bound of how much noise of one unit in every source value can move the function anywhere in
/// the shape: of nodes, Lebesgue's constant. At most 1.16 times too large for each direction in
/// which the order is above 0. Infinite where finding it would take more than a tenth of a second
/// (tetrahedra above order 7, pyramids above 6).
[[nodiscard]] double NoiseBound(const ChangeOfBasis& change);

/// Bounds how far rounding can move a map that a change of basis computed from coordinates.
class MapNoise
{
public:
  explicit MapNoise(const ChangeOfBasis& change);

  /// `roundings` is how far each source value may be off, `modes` the map's modes, component by
  /// component, in the same unit. The lesser of two bounds: what noise in the source values can put
  /// into all modes together, and NoiseBound times that noise and the rounding of the modes.
  [[nodiscard]] double Of(double roundings, std::span<const double> modes) const;

private:
  std::vector<double> Bounds; ///< of |mode|
  double OfModes = 0.0;       ///< for noise of one unit
  double OfMap = 0.0;
};
} // namespace pixelexact
