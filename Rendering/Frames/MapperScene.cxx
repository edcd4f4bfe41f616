// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/MapperScene.h"

#include "Frames/LayerRequests.h"
#include "Views/VtkColorMap.h"
#include "Views/VtkLook.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderSceneMapper.h"
#include "vtkHighOrderSurface.h"

#include "vtkImplicitFunction.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
CutSource SourceOf(vtkHighOrderLayer* layer)
{
  return { layer->GetCutFunction(), layer->GetSurface() };
}

std::shared_ptr<const Surface> SurfaceOf(vtkHighOrderSceneMapper* mapper, const CutSource& cut,
  const std::shared_ptr<HighOrderModel>& model, SurfaceCache& surfaces)
{
  if (cut.surface != nullptr && !mapper->GetStatic())
  {
    cut.surface->Update();
  }
  return surfaces.Of(cut, model, mapper->GetSearchSamples());
}
} // namespace

bool MapperScene::IsEmpty() const
{
  return cuts.empty() && surface == nullptr && layers.empty();
}

bool MapperScene::Has(vtkHighOrderSceneMapper* mapper, bool opaque) const
{
  const bool own = std::ranges::any_of(layers,
    [&](vtkHighOrderLayer* layer)
    { return layer->GetVisibility() && IsOpaque(mapper, layer) == opaque; });
  const bool plain = !(cuts.empty() && surface == nullptr) && IsOpaque(mapper, nullptr) == opaque;
  return plain || own || (opaque && this->IsEmpty());
}

vtkMTimeType MapperScene::GetMTime() const
{
  vtkMTimeType time = 0;
  for (const CutSource& cut : this->Plain())
  {
    time = std::max(time, cut.Object()->GetMTime());
  }
  for (const auto& layer : layers)
  {
    time = std::max(time, layer->GetMTime());
  }
  return time;
}

std::vector<CutSource> MapperScene::Plain() const
{
  std::vector<CutSource> plain;
  for (const auto& cut : cuts)
  {
    plain.push_back({ cut, nullptr });
  }
  if (surface != nullptr)
  {
    plain.push_back({ nullptr, surface });
  }
  return plain;
}

std::vector<LayerRequest> MapperScene::MakeLayers(vtkHighOrderSceneMapper* mapper,
  const LayerRequest& ofAll, const std::shared_ptr<HighOrderModel>& model,
  SurfaceCache& surfaces) const
{
  std::vector<LayerRequest> requests;
  std::vector<CutSource> sources = this->Plain();
  for (const CutSource& cut : sources)
  {
    requests.push_back(ofAll);
    requests.back().surface = SurfaceOf(mapper, cut, model, surfaces);
  }
  for (const auto& layer : layers)
  {
    sources.push_back(SourceOf(layer));
    if (layer->GetVisibility())
    {
      LayerRequest own = LayerOf(layer, ofAll);
      const bool hasOwn = layer->GetContourCount() > 0 || layer->GetNumberOfContours() > 0;
      if (hasOwn && !mapper->GetContourScalarVisibility())
      {
        // Contours without colours of their own get the mapper's contour colour.
        own.appearance.contours.colors = { ToRgba(mapper->GetContourColor()) };
      }
      own.surface = SurfaceOf(mapper, sources.back(), model, surfaces);
      requests.push_back(std::move(own));
    }
  }
  surfaces.KeepOnly(sources);
  return requests;
}
} // namespace pixelexact
