// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <array>

namespace pixelexact
{
/// A shape's face in two of its xi, u and v, in the order of the directions: the third is linear in
/// them, and pieces of the face lie, for each v, between two u.
struct FaceChart
{
  std::array<int, 2> free{ 0, 1 }; ///< which xi u and v are
  int across = 2;                  ///< the third
  double constant = -1.0;          ///< of the third
  std::array<double, 2> along{};   ///< its derivatives by u and v: 0 or -1
  bool collapses = false;          ///< the ends of u move with v, half as fast at most
};

FaceChart ChartOf(Shape shape, int face);
} // namespace pixelexact
