// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

// Checks of surfaces' arguments. Each throws an Error that begins with the surface's name.
namespace pixelexact
{
[[noreturn]] void Refuse(const char* surface, const char* why);

bool IsFinite(const Vec3& x);
double LargestOf(const Vec3& x);

void CheckPosition(const Vec3& position, const char* surface);
/// Requires a radius between 1e-100 and 1e100, so that its square and the square's rounding error
/// are normal numbers.
void CheckRadius(double radius, const char* surface);
/// The direction times a power of two, with coordinates of at most 1; `name` is its name in
/// messages.
Vec3 ScaledDirection(const Vec3& direction, const char* surface, const char* name);
/// The unit vector along a direction of any length except zero.
Vec3 UnitDirection(const Vec3& direction);
/// The same, or zero for a direction that is zero or not finite.
Vec3 UnitOrZero(const Vec3& direction);
} // namespace pixelexact
