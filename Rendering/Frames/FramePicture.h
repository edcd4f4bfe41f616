// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameSource.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>

class vtkImageData;

namespace pixelexact
{
/// A frame of the source as ToImageData makes it, and the verdicts on its contours.
[[nodiscard]] vtkSmartPointer<vtkImageData> ToImageData(
  const FrameSource& source, const Frame& frame);

struct FramePicture
{
  vtkSmartPointer<vtkImageData> image;         ///< null where it was aborted
  std::optional<std::array<double, 2>> fitted; ///< that the request's table got
};

/// The complete frame that is asked for, in the range of what it shows where the request has a
/// table to be fitted; `allBuffers`: with all that is known of pixels. Throws Error.
[[nodiscard]] FramePicture TracePicture(
  FrameSource& source, const FrameRequest& request, bool allBuffers, const Progress& progress);
} // namespace pixelexact
