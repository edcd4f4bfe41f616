// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FramePicture.h"

#include "Frames/FrameImage.h"
#include "HighOrderModel.h"

#include "vtkImageData.h"

namespace pixelexact
{
vtkSmartPointer<vtkImageData> ToImageData(const FrameSource& source, const Frame& frame)
{
  auto image = ToImageData(frame, source.Model()->SourceCells(), source.Model()->Blocks());
  if (const ContourCertifier* contours = source.LastContours())
  {
    AddContours(*image, contours->Verdicts());
  }
  return image;
}

vtkSmartPointer<vtkImageData> TracePicture(
  FrameSource& source, const FrameRequest& request, bool allBuffers, const Progress& progress)
{
  const Frame* frame = &source.Render(request, progress);
  return source.IsComplete()
    ? ToImageData(source, allBuffers ? *source.FrameWithAllBuffers() : *frame)
    : nullptr;
}
} // namespace pixelexact
