// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FramePicture.h"

#include "Frames/ColorRanges.h"
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

FramePicture TracePicture(
  FrameSource& source, const FrameRequest& request, bool allBuffers, const Progress& progress)
{
  FramePicture picture;
  FrameRequest first = request;
  first.counts = request.fitted == nullptr;
  const Frame* frame = &source.Render(first, progress);
  if (source.IsComplete() && request.fitted != nullptr)
  {
    const auto fitted = ColorRanges::OfFrame(*frame, request, request.fitted);
    if (fitted && ColorRanges::Set(request.fitted, *fitted))
    {
      picture.fitted = fitted;
    }
    frame = &source.Render(request, progress);
  }
  if (source.IsComplete())
  {
    picture.image = ToImageData(source, allBuffers ? *source.FrameWithAllBuffers() : *frame);
  }
  return picture;
}
} // namespace pixelexact
