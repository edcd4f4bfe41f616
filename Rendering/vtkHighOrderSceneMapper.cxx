// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHighOrderSceneMapper.h"

#include "Frames/MapperScene.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderSurface.h"

#include "vtkImplicitFunction.h"

#include <algorithm>
#include <cstddef>
#include <vector>

//------------------------------------------------------------------------------
vtkHighOrderSceneMapper::vtkHighOrderSceneMapper()
  : Scene(std::make_unique<pixelexact::MapperScene>())
{
}

//------------------------------------------------------------------------------
vtkHighOrderSceneMapper::~vtkHighOrderSceneMapper() = default;

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::SetCutFunction(vtkImplicitFunction* function)
{
  auto& cuts = this->Scene->cuts;
  const std::size_t wanted = function != nullptr ? 1 : 0;
  if (cuts.size() != wanted || (wanted == 1 && cuts[0] != function))
  {
    cuts.assign(wanted, function);
    this->Modified();
  }
  if (function != nullptr)
  {
    this->SetSurface(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::AddCutFunction(vtkImplicitFunction* function)
{
  if (function != nullptr)
  {
    this->Scene->cuts.emplace_back(function);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::RemoveCutFunction(vtkImplicitFunction* function)
{
  if (std::erase(this->Scene->cuts, function) > 0)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::RemoveAllCutFunctions()
{
  this->SetCutFunction(nullptr);
}

//------------------------------------------------------------------------------
int vtkHighOrderSceneMapper::GetNumberOfCutFunctions()
{
  return static_cast<int>(this->Scene->cuts.size());
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkHighOrderSceneMapper::GetCutFunction(int index)
{
  return index >= 0 && index < this->GetNumberOfCutFunctions()
    ? this->Scene->cuts[static_cast<std::size_t>(index)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::SetSurface(vtkHighOrderSurface* surface)
{
  if (surface != nullptr)
  {
    this->RemoveAllCutFunctions();
  }
  if (this->Scene->surface != surface)
  {
    this->Scene->surface = surface;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHighOrderSurface* vtkHighOrderSceneMapper::GetSurface()
{
  return this->Scene->surface;
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::AddLayer(vtkHighOrderLayer* layer)
{
  if (layer != nullptr)
  {
    this->Scene->layers.emplace_back(layer);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::RemoveLayer(vtkHighOrderLayer* layer)
{
  if (std::erase(this->Scene->layers, layer) > 0)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::RemoveAllLayers()
{
  if (!this->Scene->layers.empty())
  {
    this->Scene->layers.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHighOrderSceneMapper::GetNumberOfLayers()
{
  return static_cast<int>(this->Scene->layers.size());
}

//------------------------------------------------------------------------------
vtkHighOrderLayer* vtkHighOrderSceneMapper::GetLayer(int index)
{
  return index >= 0 && index < this->GetNumberOfLayers()
    ? this->Scene->layers[static_cast<std::size_t>(index)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHighOrderSceneMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Scene->GetMTime());
}

//------------------------------------------------------------------------------
bool vtkHighOrderSceneMapper::HasOpaqueGeometry()
{
  return this->Scene->Has(this, true);
}

//------------------------------------------------------------------------------
bool vtkHighOrderSceneMapper::HasTranslucentPolygonalGeometry()
{
  return this->Scene->Has(this, false);
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (auto* other = vtkHighOrderSceneMapper::SafeDownCast(mapper))
  {
    this->SetLightFlat(other->LightFlat);
    this->SetSearchSamples(other->SearchSamples);
    this->SetSamples(other->Samples);
    this->SetEdgesByKind(other->EdgesByKind);
    this->SetOutlines(other->Outlines);
    this->SetOutlineColor(other->OutlineColor);
    *this->Scene = *other->Scene;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHighOrderSceneMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CutFunctions: " << this->Scene->cuts.size() << "\n";
  for (const auto& cut : this->Scene->cuts)
  {
    cut->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Surface: "
     << (this->Scene->surface != nullptr ? this->Scene->surface->GetClassName() : "(none)") << "\n";
  os << indent << "Layers: " << this->Scene->layers.size() << "\n";
  for (const auto& layer : this->Scene->layers)
  {
    layer->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "LightFlat: " << (this->LightFlat ? "on" : "off") << "\n";
  os << indent << "SearchSamples: " << this->SearchSamples << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "EdgesByKind: " << (this->EdgesByKind ? "on" : "off") << "\n";
  os << indent << "Outlines: " << (this->Outlines ? "on" : "off") << "\n";
  os << indent << "OutlineColor: " << this->OutlineColor[0] << ", " << this->OutlineColor[1] << ", "
     << this->OutlineColor[2] << "\n";
}
