// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FacePlane.h"
#include "Trace/Camera.h"
#include "Trace/Modules/FaceLines.h"

#include <array>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// Faces of an element, and the distance within which they count.
struct FaceReach
{
  std::span<const FacePlane> faces;
  double size = 1.0;   ///< of the element
  double across = 0.0; ///< step of (u, v) per pixel
  double up = 0.0;
  double reach = 0.0; ///< in pixels
};

/// In lanes, dispatched at run time to the instruction set.
struct FaceKernels
{
  /// Sets near[i] to 1 if a face may be nearer than the reach to first order, or if a number is not
  /// finite; else to 0. `jacobian`: nine columns, row-major.
  void (*findNear)(const CameraRays& camera, const FaceReach& reach, const FacePixels& pixels,
    const std::array<const double*, 9>& jacobian, std::uint8_t* near);
};

const FaceKernels& GetFaceKernels();
} // namespace pixelexact
