// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

// Positions in an element from which the sweeps take points.
namespace pixelexact::testing
{
/// A point of the shape: half of them in the volume, the others on faces, edges and vertices.
Vec3 AnywhereInside(Shape shape, Random& random);

/// A point beyond one of the shape's faces, by 1e-16 to `reach` in eta.
Vec3 BeyondAFace(Shape shape, double reach, Random& random);

/// A point of the shape at about `distance` from what it collapses, in any direction; not for
/// hexahedra.
Vec3 NearCollapsed(Shape shape, double distance, Random& random);

/// The same, but outside, by about `distance` at most.
Vec3 BeyondNearCollapsed(Shape shape, double distance, Random& random);
} // namespace pixelexact::testing
