// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameSource.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace pixelexact
{
/// A frame of the source as ToImageData makes it, and the verdicts on its contours.
[[nodiscard]] vtkSmartPointer<vtkImageData> ToImageData(
  const FrameSource& source, const Frame& frame);

/// The complete frame that is asked for; `allBuffers`: with all that is known of pixels. Null where
/// it was aborted. Throws Error.
[[nodiscard]] vtkSmartPointer<vtkImageData> TracePicture(
  FrameSource& source, const FrameRequest& request, bool allBuffers, const Progress& progress);
} // namespace pixelexact
