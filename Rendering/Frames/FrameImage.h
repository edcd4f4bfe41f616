// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HighOrderModel.h"
#include "PixelExactRenderingModule.h"
#include "Trace/Frame.h"
#include "Trace/Renderer.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <span>

class vtkImageData;

namespace pixelexact
{
class HighOrderModel;

/// A frame of the model as an image (ToImageData below), with the verdicts on its contours.
[[nodiscard]] vtkSmartPointer<vtkImageData> ToImageData(
  const Renderer& frames, const HighOrderModel& model, const Frame& frame);

/// The view's complete frame as an image; `allBuffers`: with all buffers. Null if it was aborted.
/// Throws Error.
[[nodiscard]] vtkSmartPointer<vtkImageData> TracePicture(Renderer& frames, const View& view,
  const RenderWork& work, const HighOrderModel& model, bool allBuffers, const Progress& progress);

/// The buffers of a frame (BufferTable.h) and its image as point arrays of an image, one point per
/// pixel, lower left first. Buffers that the frame does not hold have no array. Only the image
/// includes what translucent layers show. `sourceCells`: source cells of the mesh's elements;
/// empty: element numbers are kept. `blocks`: of composite data; adds an array Block of flat
/// indices beside Element, -1 without an element.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkImageData> ToImageData(
  const Frame& frame, std::span<const std::int64_t> sourceCells,
  std::span<const HighOrderModel::Block> blocks = {});

/// Adds the array Contour, a ContourVerdict for each pixel; not if `verdicts` is empty.
PIXELEXACTRENDERING_EXPORT void AddContours(
  vtkImageData& image, std::span<const std::uint8_t> verdicts);
} // namespace pixelexact
