// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Camera.h"

// Moves of a camera, for animations and for dragging in a page.
namespace pixelexact
{
/// Rotates `v` about an axis of unit length by `angle` radians (O. Rodrigues, 1840).
[[nodiscard]] Vec3 Rotated(const Vec3& v, const Vec3& axis, double angle);

/// Turns the camera about its focal point: by `right` radians about its view-up, then by `up`
/// radians about its horizontal axis. Objects follow the pointer. View-up stays perpendicular to
/// the direction of view.
[[nodiscard]] CameraView Turned(const CameraView& view, double right, double up);

/// Moves camera and focal point in the image plane, so that objects near the focal point move by
/// parts of the image's height, to the right and upwards.
[[nodiscard]] CameraView Moved(const CameraView& view, double right, double up);

/// Enlarges what is at the focal point by `factor`, above 0: a parallel view by its scale, another
/// one by its distance.
[[nodiscard]] CameraView Zoomed(const CameraView& view, double factor);
} // namespace pixelexact
