// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/LineFunctions.h"
#include "Core/Basis/Space.h"

#include <functional>
#include <vector>

// The factors of a ChangeOfBasis: dense matrices, made by interpolation in long double.
namespace pixelexact
{
using LongVec3 = std::array<long double, 3>;

/// A matrix from `columns` source functions to `rows` modes.
struct BasisFactor
{
  int rows = 0;
  int columns = 0;
  std::vector<long double> matrix; ///< row-major
  /// The space of the modes in a ChangeOfBasis: for a line, the hexahedron's modes (p, 0, 0); for a
  /// triangle, the prism's (p, 0, r).
  Space space{};
};

/// Values of all canonical modes at xi, in order of storage; `out` holds space.Modes().
void EvaluateModes(const Space& space, const LongVec3& xi, long double* out);

/// Points at which interpolation in `space` is unique: the tensor grid of Chebyshev's points for
/// tensor spaces, and for collapsed ones their images, thinned out to the modes' staircase.
std::vector<LongVec3> UnisolventPoints(const Space& space);

/// The factor that gives the modes the values of the sources at `modes` points; row-major, point by
/// point.
BasisFactor SolveFactor(int modes, int sources, const std::vector<long double>& modesAtPoints,
  const std::vector<long double>& sourcesAtPoints);

/// Functions of one coordinate to Legendre's polynomials. Throws InvalidData for functions that are
/// no polynomials of that order (up to 1e-10).
BasisFactor LineFactor(int order, const LineFunctions& line);

/// Any functions to the modes of `space`. Throws as LineFactor.
BasisFactor SolidFactor(const Space& space, int count,
  const std::function<void(const LongVec3&, long double*)>& functions);
} // namespace pixelexact
