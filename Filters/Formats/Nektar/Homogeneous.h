// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <string>
#include <vector>

// Homogeneous expansions: Fourier's functions along z over a two-dimensional mesh. Their elements
// become solids in layers, with polynomials along z that are proven to be near enough.
namespace pixelexact::nektar
{
/// Along z from 0 to `length`: function 2 k is cos(2 pi k z / length), function 2 k + 1 is
/// -sin(2 pi k z / length).
struct Homogeneous
{
  double length = 1.0;
  std::vector<int> functions; ///< those that there are, by number
  /// Of a complex wave the file has one part alone: of the field "w" the imaginary one, function 3,
  /// of all others the real one, minus function 2.
  bool isHalfMode = false;

  bool operator==(const Homogeneous&) const = default;
};

/// What a polynomial along z may lose, in parts of the field's range.
inline constexpr double kHomogeneousLoss = 1e-13;

/// A field: per function of z the coefficients on the plane elements.
struct HomogeneousField
{
  std::string name;
  std::string basis;
  std::vector<SolverExpansion> planes;
};

/// Makes the model of a slab one of layers, in place, with these fields. An element of layer l has
/// l times (1 + the largest number) added to its number. Notes say how many layers and which order
/// there are, and what is lost at most.
void LiftHomogeneous(
  const Homogeneous& along, const std::vector<HomogeneousField>& fields, SolverModel& model);
} // namespace pixelexact::nektar
