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
/// What a mapper cuts with.
struct MapperScene
{
  std::vector<vtkSmartPointer<vtkImplicitFunction>> cuts;
  vtkSmartPointer<vtkHighOrderSurface> surface;
  std::vector<vtkSmartPointer<vtkHighOrderLayer>> layers;

  [[nodiscard]] bool IsEmpty() const;
  /// Whether there is something opaque to draw, or something that is not. Nothing at all is opaque:
  /// somebody has to say what is missing.
  [[nodiscard]] bool Has(vtkHighOrderSceneMapper* mapper, bool opaque) const;
  /// The last change of anything in it.
  [[nodiscard]] vtkMTimeType GetMTime() const;

  /// Cut functions and surface, which are drawn as `ofAll`, and visible layers, which have settings
  /// of their own. Throws Error.
  [[nodiscard]] std::vector<LayerRequest> MakeLayers(vtkHighOrderSceneMapper* mapper,
    const LayerRequest& ofAll, const std::shared_ptr<HighOrderModel>& model,
    SurfaceCache& surfaces) const;

private:
  /// Cut functions and surface.
  [[nodiscard]] std::vector<CutSource> Plain() const;
};
} // namespace pixelexact
