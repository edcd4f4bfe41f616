// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Renderer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkMapper;
class vtkMatrix4x4;
class vtkRenderer;

// What a single ray meets, by the same machinery as frames.
namespace pixelexact
{
class HighOrderModel;

/// Where to pick: a pixel of a renderer, or a ray.
struct PickRay
{
  vtkRenderer* renderer = nullptr;
  /// In the renderer's viewport, lower left first: the ray through its centre. None: from start to
  /// end, in the data's coordinates, whatever the camera.
  std::optional<std::array<int, 2>> pixel;
  Vec3 start{ 0.0 };
  Vec3 end{ 0.0 };
  vtkMatrix4x4* dataToWorld = nullptr;
  double opacity = 1.0; ///< of the actor
};

/// What is met, in the data's coordinates.
struct PickedSample
{
  Vec3 position;
  Vec3 normal; ///< of the cut-surface
  PixelVerdict verdict = PixelVerdict::Unknown;
  int layer = 0;            ///< of the view
  std::int64_t cell = -1;   ///< of the grid, or of the block
  std::int64_t source = -1; ///< the element's cell in the source
  std::int64_t block = -1;  ///< flat index, of composite data
  // Where the verdict is Exact:
  Vec3 xi;
  double value = 0.0;         ///< of the component that is shown
  std::vector<double> values; ///< of all of the field's components
  std::string field;
};

/// The first sample along the ray that is shown (its colour and the actor not wholly transparent),
/// between near and far plane or start and end, inside of the mapper's clipping planes. Throws
/// Error. `view`: of the model, completed here. `ranges`: those of its fields.
std::optional<PickedSample> Pick(Renderer& frames, View view, const HighOrderModel& model,
  const std::shared_ptr<FieldRanges>& ranges, const PickRay& ray, vtkMapper* mapper);
} // namespace pixelexact
