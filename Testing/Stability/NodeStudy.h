// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stability/Report.h"

#include "Core/Shape/Shape.h"

namespace pixelexact::testing
{
enum class Nodes
{
  Equispaced,
  GaussLobatto ///< hexahedra only
};

const char* Name(Nodes nodes);

/// Interpolates a smooth polynomial of the given order, its values at the nodes rounded to double,
/// by ChangeOfBasis, and compares the result at points between the nodes with the polynomial. The
/// condition is Lebesgue's function weighted with the values, over the largest value; errors are in
/// ulps of the largest value. Allowed, u = 2^-53:
///   u sum |value| |Lagrange function|   what the values' rounding explains, at the point,
///   u sum |c| |mode|                    rounding of the coefficients, at the point,
///   2^-64 24 (order + 1) times the first sum at its largest: the conversion's own rounding, which
///   is spread over the element. Three directions, each with a solution and a product of order + 1
///   terms.
Row StudyNodes(Shape shape, Nodes nodes, int order, int points);
} // namespace pixelexact::testing
