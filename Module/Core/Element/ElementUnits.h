// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

namespace pixelexact
{
/// Unit roundoffs of its largest coordinate by which a coordinate in a file may be off: half a unit
/// in the last place from writing it and a few from the solver's evaluation.
inline constexpr double kCoordinateRoundings = 4.0;

/// Unit roundoff of coordinates in single precision.
inline constexpr double kFloatRoundoff = 0x1p-24;

/// The units in which an element's map is stored (Mesh in Core/Element/Mesh.h).
struct ElementUnits
{
  Vec3 centre{ 0.0 };
  int exponent = 0;     ///< size = 2^exponent
  double largest = 0.0; ///< the largest |coordinate| of the box
};

/// The units of an element whose nodes lie in the box from `low` to `high`. Throws InvalidData,
/// "is too large ...", where the size exceeds what double arithmetic can square.
ElementUnits MakeElementUnits(const Vec3& low, const Vec3& high);
} // namespace pixelexact
