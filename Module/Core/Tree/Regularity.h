// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Tree/NodeFrame.h"

namespace pixelexact
{
/// The distance, in widths of a box, to which proofs of regularity extend beyond its ends.
double ReachOf(const std::array<int, 3>& degree);

/// Bounds the sum of the magnitudes of the Bernstein polynomials of this degree over a box and its
/// reach.
double GrowthInReach(const std::array<int, 3>& degree);

/// Whether Phi is injective on the box, reaching beyond its ends by ReachOf (but not beyond a
/// collapsed end): over the convex polytope M times the Jacobian by xi, M about the inverse of its
/// middle, lies in an interval matrix that is strictly diagonally dominant, so that
/// M (Phi(b) - Phi(a)), a mean of that times b - a, vanishes for a = b alone. `slopes`: nine
/// functions d Phi_c / d xi_j over the box, c slowest.
bool IsRegular(const std::array<int, 3>& degree, const BoxCoefficients& slopes);

/// Whether an end eta_d = 1 is a collapsed edge or vertex.
bool CollapsesAt(Shape shape, int direction);

/// Whether the map with these modes, in the element's units, has no thickness at points all over a
/// box of eta: det J is at most 1e-14 of the largest area between two of J's columns. Subdivision
/// of such boxes does not help. This is not a proof.
bool IsFlatOver(const Space& space, const double* modes, const EtaBox& box);
} // namespace pixelexact
