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
/// How far faces count.
struct FaceReach
{
  std::span<const FacePlane> faces;
  double size = 1.0;   ///< of the element
  double across = 0.0; ///< of (u, v), a pixel
  double up = 0.0;
  double reach = 0.0; ///< in pixels
};

/// In lanes, dispatched at run time to the instruction set.
struct FaceKernels
{
  /// near[i] = 1 where a face may be nearer than the reach, to first order, else 0: also where
  /// something is not finite. `jacobian`: nine columns, row by row.
  void (*findNear)(const CameraRays& camera, const FaceReach& reach, const FacePixels& pixels,
    const std::array<const double*, 9>& jacobian, std::uint8_t* near);
};

const FaceKernels& GetFaceKernels();
} // namespace pixelexact
