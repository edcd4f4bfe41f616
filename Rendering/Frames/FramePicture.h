// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Renderer.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace pixelexact
{
class HighOrderModel;

/// A frame of the model as ToImageData makes it, and the verdicts on its contours.
[[nodiscard]] vtkSmartPointer<vtkImageData> ToImageData(
  const Renderer& frames, const HighOrderModel& model, const Frame& frame);

/// The view's complete frame; `allBuffers`: with all buffers. Null where it was aborted. Throws
/// Error.
[[nodiscard]] vtkSmartPointer<vtkImageData> TracePicture(Renderer& frames, const View& view,
  const HighOrderModel& model, bool allBuffers, const Progress& progress);
} // namespace pixelexact
