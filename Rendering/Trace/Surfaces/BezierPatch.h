// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// A tensor-product Bezier patch: points[i (degree[1] + 1) + j], rows of u.
struct BezierPatch
{
  int degree[2]{ 3, 3 };
  std::vector<Vec3> points;
};
} // namespace pixelexact
