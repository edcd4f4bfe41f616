// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FramePicture.h"

#include "Frames/FrameImage.h"
#include "HighOrderModel.h"

#include "vtkImageData.h"

namespace pixelexact
{
vtkSmartPointer<vtkImageData> ToImageData(
  const Renderer& frames, const HighOrderModel& model, const Frame& frame)
{
  auto image = ToImageData(frame, model.SourceCells(), model.Blocks());
  if (const ContourCertifier* contours = frames.LastContours())
  {
    AddContours(*image, contours->Verdicts());
  }
  return image;
}

vtkSmartPointer<vtkImageData> TracePicture(Renderer& frames, const View& view,
  const HighOrderModel& model, bool allBuffers, const Progress& progress)
{
  const Frame* frame = &frames.Render(view, {}, progress);
  return frames.IsComplete()
    ? ToImageData(frames, model, allBuffers ? *frames.FrameWithAllBuffers() : *frame)
    : nullptr;
}
} // namespace pixelexact
