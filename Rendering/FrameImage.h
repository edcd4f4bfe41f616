// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Frame.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <span>

class vtkImageData;

namespace pixelexact
{
/// The buffers of a frame as point arrays of an image, one point per pixel, lower left first:
/// Value (double), Position, Normal, Xi (3 doubles), Element (int64, -1 none), Depth (double),
/// Verdict (uint8), Owners (int32), Coverage (uint8), Value_lower, Value_upper (double), Color
/// (RGBA uint8). Buffers that the frame does not hold have no array.
/// `sourceCells` translates the mesh's element numbers into what users know; empty: they stay.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkImageData> ToImageData(
  const Frame& frame, std::span<const std::int64_t> sourceCells);
} // namespace pixelexact
