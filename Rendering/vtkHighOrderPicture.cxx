// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderPicture.h"

#include "Frames/ContourLabels.h"
#include "Frames/ViewRequest.h"
#include "Trace/Renderer.h"
#include "Views/FittedView.h"
#include "Views/MapperExecutive.h"
#include "Views/VtkCamera.h"
#include "vtkHighOrderMapper.h"

#include "Core/Base/Error.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkHighOrderPicture);

struct vtkHighOrderPicture::Internals
{
  pixelexact::RenderCounters Counters;
  pixelexact::Renderer Frames{ Counters, &pixelexact::DrawLabelsOf };
};

namespace
{
vtkHighOrderMapper* MapperOf(vtkActor* actor)
{
  return actor != nullptr ? vtkHighOrderMapper::SafeDownCast(actor->GetMapper()) : nullptr;
}
} // namespace

vtkHighOrderPicture::vtkHighOrderPicture()
  : Data(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHighOrderPicture::~vtkHighOrderPicture() = default;

void vtkHighOrderPicture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actor: " << (this->Actor ? "" : "(none)") << "\n";
  os << indent << "Camera: " << (this->Camera ? "" : "(none)") << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Stride: " << this->Stride << "\n";
  os << indent << "AllBuffers: " << (this->AllBuffers ? "on" : "off") << "\n";
}

void vtkHighOrderPicture::SetActor(vtkActor* actor)
{
  if (this->Actor != actor)
  {
    this->Actor = actor;
    this->Modified();
  }
}

vtkActor* vtkHighOrderPicture::GetActor()
{
  return this->Actor;
}

void vtkHighOrderPicture::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkHighOrderPicture::GetCamera()
{
  return this->Camera;
}

void vtkHighOrderPicture::ViewAlong(const double towardsViewer[3], const double viewUp[3])
{
  if (!this->Camera)
  {
    this->SetCamera(vtkSmartPointer<vtkCamera>::New());
  }
  const double* bounds = this->Actor ? this->Actor->GetBounds() : nullptr;
  pixelexact::Box3 box;
  for (int i = 0; i < 3 && bounds != nullptr; ++i)
  {
    box.lower[i] = bounds[2 * i];
    box.upper[i] = bounds[2 * i + 1];
  }
  try
  {
    pixelexact::CameraView view = pixelexact::ViewOfBox(box,
      pixelexact::Vec3(towardsViewer[0], towardsViewer[1], towardsViewer[2]), this->Size[0],
      this->Size[1], pixelexact::Vec3(viewUp[0], viewUp[1], viewUp[2]),
      this->Camera->GetParallelProjection() != 0, this->Camera->GetViewAngle());
    if (vtkHighOrderMapper* mapper = MapperOf(this->Actor))
    {
      view = pixelexact::FitView(view, this->Size[0], this->Size[1], false,
        [&](const pixelexact::CameraView& from)
        {
          pixelexact::ApplyView(from, this->Camera);
          const auto [width, height] = pixelexact::SmallSize(this->Size[0], this->Size[1]);
          std::vector<pixelexact::Vec3> points;
          for (const auto& x : mapper->SeenPoints({ .camera = this->Camera,
                                                    .actor = this->Actor,
                                                    .mapper = mapper,
                                                    .width = width,
                                                    .height = height }))
          {
            points.emplace_back(x[0], x[1], x[2]);
          }
          return points;
        });
    }
    pixelexact::ApplyView(view, this->Camera);
  }
  catch (const pixelexact::Error& error)
  {
    vtkErrorMacro("ViewAlong: " << error.what());
  }
}

void vtkHighOrderPicture::ViewAlong(const double towardsViewer[3])
{
  const pixelexact::Vec3 up =
    pixelexact::UsualUp({ towardsViewer[0], towardsViewer[1], towardsViewer[2] });
  const double viewUp[3] = { up.x, up.y, up.z };
  this->ViewAlong(towardsViewer, viewUp);
}

vtkIdType vtkHighOrderPicture::GetNumberOfTraces()
{
  return this->Data->Counters.traces;
}

vtkMTimeType vtkHighOrderPicture::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Actor)
  {
    time = std::max(time, this->Actor->GetMTime());
  }
  if (vtkHighOrderMapper* mapper = MapperOf(this->Actor))
  {
    time = std::max(time, mapper->GetMTime());
    if (!mapper->GetStatic() && mapper->GetNumberOfInputConnections(0) > 0)
    {
      mapper->Update();
    }
    vtkDataObject* input = pixelexact::MapperExecutive::InputOf(mapper);
    time = input != nullptr ? std::max(time, input->GetMTime()) : time;
  }
  return this->Camera ? std::max(time, this->Camera->GetMTime()) : time;
}

int vtkHighOrderPicture::RequestInformation(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  const int extent[6] = { 0, std::max(this->Size[0], 1) - 1, 0, std::max(this->Size[1], 1) - 1, 0,
    0 };
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkHighOrderPicture::RequestData(vtkInformation* /*request*/,
  vtkInformationVector** /*inputVector*/, vtkInformationVector* outputVector)
{
  auto* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  try
  {
    vtkHighOrderMapper* mapper = MapperOf(this->Actor);
    if (mapper == nullptr || !this->Camera)
    {
      throw pixelexact::Error(mapper == nullptr
          ? "there is no actor with a vtkHighOrderMapper; give one with SetActor"
          : "there is no camera; give one with SetCamera, or call ViewAlong");
    }
    if (this->Size[0] < 1 || this->Size[1] < 1)
    {
      throw pixelexact::Error("Size: there must be at least a pixel each way");
    }
    const pixelexact::CameraSight sight{ .camera = this->Camera,
      .actor = this->Actor,
      .mapper = mapper,
      .width = this->Size[0],
      .height = this->Size[1],
      .stride = this->Stride };
    const auto picture = mapper->TracePicture(this->Data->Frames, sight, this->AllBuffers,
      [this](double done)
      {
        this->UpdateProgress(done);
        return this->GetAbortExecute() == 0;
      });
    if (picture)
    {
      output->ShallowCopy(picture);
      output->GetPointData()->SetActiveScalars("Color");
      for (const std::string& text : mapper->Complaints(this->Data->Frames, this->Actor))
      {
        vtkWarningMacro(<< text);
      }
    }
    return 1;
  }
  catch (const std::exception& error) // memory may run out too
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}
