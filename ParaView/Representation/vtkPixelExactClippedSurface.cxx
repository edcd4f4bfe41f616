// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPixelExactClippedSurface.h"

#include "Surfaces/VtkSurface.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Clipped.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkPixelExactClippedSurface);

//------------------------------------------------------------------------------
vtkPixelExactClippedSurface::vtkPixelExactClippedSurface() = default;

//------------------------------------------------------------------------------
vtkPixelExactClippedSurface::~vtkPixelExactClippedSurface() = default;

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::SetSurface(vtkHighOrderSurface* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHighOrderSurface* vtkPixelExactClippedSurface::GetSurface()
{
  return this->Surface;
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::AddCutFunction(vtkImplicitFunction* function)
{
  if (function != nullptr)
  {
    this->CutFunctions.emplace_back(function);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::RemoveAllCutFunctions()
{
  this->CutFunctions.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::AddClipFunction(vtkImplicitFunction* function, bool inverted)
{
  if (function != nullptr)
  {
    this->Clips.push_back({ function, inverted });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::RemoveAllClipFunctions()
{
  this->Clips.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::Update()
{
  if (this->Surface != nullptr)
  {
    this->Surface->Update();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPixelExactClippedSurface::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Surface != nullptr)
  {
    time = std::max(time, this->Surface->GetMTime());
  }
  for (const auto& function : this->CutFunctions)
  {
    time = std::max(time, function->GetMTime());
  }
  for (const Clip& clip : this->Clips)
  {
    time = std::max(time, clip.function->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
bool vtkPixelExactClippedSurface::IsMadeOfMesh() const
{
  return this->Surface != nullptr && this->Surface->IsMadeOfMesh();
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkPixelExactClippedSurface::MakeSurface(
  const std::shared_ptr<const pixelexact::HighOrderModel>& model,
  const pixelexact::SurfaceSearch& search)
{
  std::vector<std::shared_ptr<const pixelexact::Surface>> parts;
  if (this->Surface != nullptr)
  {
    parts.push_back(this->Surface->MakeSurface(model, search));
  }
  else
  {
    parts.reserve(this->CutFunctions.size());
    for (const auto& function : this->CutFunctions)
    {
      parts.push_back(pixelexact::ToSurface(function, search));
    }
  }
  if (parts.empty())
  {
    throw pixelexact::Error("nothing is clipped; give a surface or a cut function");
  }
  std::vector<pixelexact::Clipped::Side> sides;
  sides.reserve(this->Clips.size());
  for (const Clip& clip : this->Clips)
  {
    sides.emplace_back(
      [function = clip.function, sign = clip.inverted ? -1.0 : 1.0](const pixelexact::Vec3& x)
      { return sign * function->FunctionValue(glm::value_ptr(x)); });
  }
  return std::make_shared<pixelexact::Clipped>(std::move(parts), std::move(sides));
}

//------------------------------------------------------------------------------
void vtkPixelExactClippedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << (this->Surface != nullptr ? this->Surface->GetClassName() : "none")
     << "\n";
  os << indent << "CutFunctions: " << this->CutFunctions.size() << "\n";
  os << indent << "ClipFunctions: " << this->Clips.size() << "\n";
}
