// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderClippedSurface.h"

#include "Surfaces/VtkSurface.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Clipped.h"

#include "vtkImplicitFunction.h"
#include "vtkObjectFactory.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkHighOrderClippedSurface);

//------------------------------------------------------------------------------
vtkHighOrderClippedSurface::vtkHighOrderClippedSurface() = default;

//------------------------------------------------------------------------------
vtkHighOrderClippedSurface::~vtkHighOrderClippedSurface() = default;

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::SetSurface(vtkHighOrderSurface* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHighOrderSurface* vtkHighOrderClippedSurface::GetSurface()
{
  return this->Surface;
}

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::AddCutFunction(vtkImplicitFunction* function)
{
  if (function != nullptr)
  {
    this->CutFunctions.emplace_back(function);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::RemoveAllCutFunctions()
{
  this->CutFunctions.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::AddClipFunction(vtkImplicitFunction* function, bool inverted)
{
  if (function != nullptr)
  {
    this->Clips.push_back({ function, inverted });
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::RemoveAllClipFunctions()
{
  this->Clips.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHighOrderClippedSurface::Update()
{
  if (this->Surface != nullptr)
  {
    this->Surface->Update();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderClippedSurface::GetMTime()
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
bool vtkHighOrderClippedSurface::IsMadeOfMesh() const
{
  return this->Surface != nullptr && this->Surface->IsMadeOfMesh();
}

//------------------------------------------------------------------------------
std::shared_ptr<const pixelexact::Surface> vtkHighOrderClippedSurface::MakeSurface(
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
void vtkHighOrderClippedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << (this->Surface != nullptr ? this->Surface->GetClassName() : "none")
     << "\n";
  os << indent << "CutFunctions: " << this->CutFunctions.size() << "\n";
  os << indent << "ClipFunctions: " << this->Clips.size() << "\n";
}
