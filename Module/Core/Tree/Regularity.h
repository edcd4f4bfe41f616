// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Tree/NodeFrame.h"

namespace pixelexact
{
/// How far a box is taken to reach beyond its ends where its regularity is concerned, in widths.
double ReachOf(const std::array<int, 3>& degree);

/// What Bernstein polynomials of this degree sum to in magnitude over a box and that reach, at
/// most.
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
/// box of eta: det J is at most 1e-14 of the largest area between two of J's columns. Such boxes
/// are not worth halving; nothing is proven.
bool IsFlatOver(const Space& space, const double* modes, const EtaBox& box);
} // namespace pixelexact
