// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

namespace pixelexact
{
/// The part of a surface in an element: one of its faces (FacesOf), or the points where a component
/// has a value.
struct Sheet
{
  int face = -1; ///< -1: none
  double value = 0.0;
};

/// A point of a sheet and the ray that meets it there.
struct SheetPoint
{
  Vec3 x{ 0.0 };
  Vec3 xi{ 0.0 };
  Vec3 direction{ 0.0 }; ///< of the ray, of unit length
  double distance = 1.0; ///< from where all rays meet; of parallel ones 1
  double off = 0.0;      ///< how far x is from the ray, at most
};

/// The point where a sheet leaves its element.
struct SheetExit
{
  double part = 0.0; ///< of the straight line between two points of a surface
  SheetPoint point;
  double beside = 0.0; ///< how far it is off that line, along its ray
};
} // namespace pixelexact
