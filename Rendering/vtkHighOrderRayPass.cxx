// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderRayPass.h"

#include "vtkHighOrderMapper.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkHighOrderRayPass);

//------------------------------------------------------------------------------
vtkHighOrderRayPass::vtkHighOrderRayPass() = default;

//------------------------------------------------------------------------------
vtkHighOrderRayPass::~vtkHighOrderRayPass() = default;

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::AddActor(vtkActor* actor)
{
  if (actor != nullptr)
  {
    this->Actors.emplace_back(actor);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::RemoveActor(vtkActor* actor)
{
  if (std::erase(this->Actors, actor) > 0)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::RemoveAllActors()
{
  if (!this->Actors.empty())
  {
    this->Actors.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHighOrderRayPass::GetNumberOfActors()
{
  return static_cast<int>(this->Actors.size());
}

//------------------------------------------------------------------------------
vtkActor* vtkHighOrderRayPass::GetActor(int index)
{
  return index >= 0 && index < this->GetNumberOfActors()
    ? this->Actors[static_cast<std::size_t>(index)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::GetBounds(double bounds[6])
{
  vtkBoundingBox box;
  for (const auto& actor : this->Actors)
  {
    const double* each = actor->GetVisibility() ? actor->GetBounds() : nullptr;
    if (each != nullptr && vtkMath::AreBoundsInitialized(each))
    {
      box.AddBounds(each);
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = state->GetRenderer();
  for (const auto& actor : this->Actors)
  {
    auto* mapper = vtkHighOrderMapper::SafeDownCast(actor->GetMapper());
    if (mapper == nullptr)
    {
      vtkErrorMacro(<< "An actor of this pass has no vtkHighOrderMapper; add it to the renderer");
    }
    else if (actor->GetVisibility())
    {
      mapper->RenderAll(renderer, actor);
      ++this->NumberOfRenderedProps;
    }
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& actor : this->Actors)
  {
    actor->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderRayPass::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& actor : this->Actors)
  {
    time = std::max(time, actor->GetMTime());
    if (vtkMapper* mapper = actor->GetMapper())
    {
      time = std::max(time, mapper->GetMTime());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHighOrderRayPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actors: " << this->Actors.size() << "\n";
  for (const auto& actor : this->Actors)
  {
    actor->PrintSelf(os, indent.GetNextIndent());
  }
}
