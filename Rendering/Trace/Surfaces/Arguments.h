// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

// What surfaces are given, checked: each throws an Error that begins with the surface's name.
namespace pixelexact
{
[[noreturn]] void Refuse(const char* surface, const char* why);

bool IsFinite(const Vec3& x);
double LargestOf(const Vec3& x);

void CheckPosition(const Vec3& position, const char* surface);
/// Between 1e-100 and 1e100, so that its square and its square's rounding error are numbers.
void CheckRadius(double radius, const char* surface);
/// The direction times a power of two, with coordinates of at most 1; `name` is what it is called.
Vec3 ScaledDirection(const Vec3& direction, const char* surface, const char* name);
/// Of unit length, whatever the length of a direction that is not zero.
Vec3 UnitDirection(const Vec3& direction);
/// The same; zero for what is zero or not finite, and has no direction.
Vec3 UnitOrZero(const Vec3& direction);
} // namespace pixelexact
