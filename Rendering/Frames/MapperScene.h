// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/LayerRequests.h"
#include "Surfaces/SurfaceCache.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkHighOrderLayer;
class vtkHighOrderSceneMapper;
class vtkHighOrderSurface;
class vtkImplicitFunction;

namespace pixelexact
{
/// The cut functions, surface and layers of a mapper.
struct MapperScene
{
  std::vector<vtkSmartPointer<vtkImplicitFunction>> cuts;
  vtkSmartPointer<vtkHighOrderSurface> surface;
  std::vector<vtkSmartPointer<vtkHighOrderLayer>> layers;

  [[nodiscard]] bool IsEmpty() const;
  /// There is an opaque object to draw or, with `opaque` false, a translucent one. An empty scene
  /// counts as opaque, so that its error is reported.
  [[nodiscard]] bool Has(vtkHighOrderSceneMapper* mapper, bool opaque) const;
  /// The last modification of any of the objects.
  [[nodiscard]] vtkMTimeType GetMTime() const;

  /// The layers for cut functions and surface, which have the settings `ofAll`, and for visible
  /// layers, which have their own settings. Throws Error.
  [[nodiscard]] std::vector<LayerRequest> MakeLayers(vtkHighOrderSceneMapper* mapper,
    const LayerRequest& ofAll, const std::shared_ptr<HighOrderModel>& model,
    SurfaceCache& surfaces) const;

private:
  /// Cut functions and surface.
  [[nodiscard]] std::vector<CutSource> Plain() const;
};
} // namespace pixelexact
