// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

#include "Core/Basis/BasisFactor.h"

namespace pixelexact::nektar
{
/// Whether the points are those of a triangle.
bool IsTriangular(Distribution distribution);

/// Whether they are points of a table of ten digits.
bool IsTabulated(Distribution distribution);

/// The highest order for which a distribution is tabulated.
int HighestOrder(Distribution distribution);

/// The points of a line's distribution, from -1 to 1: order + 1 of them.
std::vector<long double> LinePoints(Distribution distribution, int order);

/// The points of a triangle's distribution as weights of its vertices, in the order of the files:
/// vertices, points on the edges one after the other, inner points.
std::vector<LongVec3> TrianglePoints(Distribution distribution, int order);
} // namespace pixelexact::nektar
