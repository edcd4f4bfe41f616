// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <vector>

namespace pixelexact
{
/// A polynomial patch by its control points: the sum over i, j of B_i(u) B_j(v) points[i *
/// (degree[1] + 1) + j], with the Bernstein polynomials B of degree[0] in u and degree[1] in v, for
/// u and v from 0 to 1. The points of one i form a row, and the patch's corners are control points.
struct BezierPatch
{
  int degree[2];
  std::vector<Vec3> points;
};
} // namespace pixelexact
