// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/ElementFunctions.h"
#include "Core/Math/Interval.h"

#include <array>

namespace pixelexact
{
/// Ranges of the map's derivatives by xi over a box, in world units.
struct BoxRanges
{
  BoxRanges(ElementFunctions& functions, const PieceBox& box);

  std::array<std::array<Interval, 3>, 3> jacobian;
  std::array<std::array<Interval, 3>, 3> cofactor;
  Interval determinant;
};

/// The range of a component of the field, in world units.
Interval FieldRange(ElementFunctions& functions, const PieceBox& box, int component);
/// The range of z = x - origin.
std::array<Interval, 3> PlaceRange(
  ElementFunctions& functions, const PieceBox& box, const Vec3& origin);
/// The range of a vector's length.
Interval Length(const std::array<Interval, 3>& v);
/// The sum of the areas of three sides of an axis-aligned box that holds the image of this one.
double SidesOf(ElementFunctions& functions, const PieceBox& box);
} // namespace pixelexact
