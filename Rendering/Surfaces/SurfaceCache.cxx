// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceCache.h"

#include "HighOrderModel.h"
#include "Surfaces/VtkSurface.h"
#include "vtkHighOrderSurface.h"

#include "Core/Location/Locator.h"

#include "vtkImplicitFunction.h"

#include <algorithm>

namespace pixelexact
{
vtkObject* CutSource::Object() const
{
  return surface != nullptr ? static_cast<vtkObject*>(surface) : function;
}

std::shared_ptr<const Surface> SurfaceCache::Of(
  const CutSource& source, const std::shared_ptr<HighOrderModel>& model, int samples)
{
  DropOthers(model);
  vtkObject* const object = source.Object();
  const std::uint64_t state = object != nullptr ? object->GetMTime() : 0;
  auto found =
    std::ranges::find_if(Entries, [object](const Entry& entry) { return entry.source == object; });
  if (found != Entries.end())
  {
    if (found->state == state && found->samples == samples)
    {
      return found->surface;
    }
    Entries.erase(found);
  }
  if (source.function != nullptr || (source.surface != nullptr && !source.surface->IsMadeOfMesh()))
  {
    model->RequireSolids("cut-surface");
  }
  const SurfaceSearch search{ model->GetLocator().Bounds(), samples };
  Entry entry{ object, state, samples, true, nullptr };
  entry.ofModel = source.surface == nullptr || source.surface->IsMadeOfMesh();
  entry.surface = source.surface != nullptr ? source.surface->MakeSurface(model, search)
                                            : ToSurface(source.function, search);
  ++Count;
  return Entries.emplace_back(std::move(entry)).surface;
}

void SurfaceCache::KeepOnly(std::span<const CutSource> sources)
{
  std::erase_if(Entries,
    [sources](const Entry& entry)
    {
      return std::ranges::none_of(
        sources, [&entry](const CutSource& source) { return source.Object() == entry.source; });
    });
}

void SurfaceCache::DropOthers(const std::shared_ptr<HighOrderModel>& model)
{
  if (Model.lock() != model || !model)
  {
    std::erase_if(Entries, [](const Entry& entry) { return entry.ofModel; });
    Model = model;
  }
}
} // namespace pixelexact
