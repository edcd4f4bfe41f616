// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <array>

namespace pixelexact
{
/// A shape's face in two of its xi, u and v, in the order of the directions. The third xi is linear
/// in them, and pieces of the face lie, for each v, between two u.
struct FaceChart
{
  std::array<int, 2> free{ 0, 1 }; ///< indices of u and v in xi
  int across = 2;                  ///< index of the third xi
  double constant = -1.0;          ///< constant term of the third xi
  std::array<double, 2> along{};   ///< derivatives of the third xi by u and v: 0 or -1
  bool collapses = false;          ///< the ends of u depend on v, with slopes of at most one half
};

FaceChart ChartOf(Shape shape, int face);
} // namespace pixelexact
