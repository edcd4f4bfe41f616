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

// Picking with a single ray, by the same code as frames.
namespace pixelexact
{
class HighOrderModel;

/// A pixel of a renderer, or a ray, to pick with.
struct PickRay
{
  vtkRenderer* renderer = nullptr;
  /// Pixel in the renderer's viewport, lower left first; the ray passes its centre. None: the ray
  /// leads from start to end, in the data's coordinates, for any camera.
  std::optional<std::array<int, 2>> pixel;
  Vec3 start{ 0.0 };
  Vec3 end{ 0.0 };
  vtkMatrix4x4* dataToWorld = nullptr;
  double opacity = 1.0; ///< of the actor
};

/// A picked point, in the data's coordinates.
struct PickedSample
{
  Vec3 position;
  Vec3 normal; ///< of the cut-surface
  PixelVerdict verdict = PixelVerdict::Unknown;
  int layer = 0;            ///< of the view
  std::int64_t cell = -1;   ///< of the grid, or of the block
  std::int64_t source = -1; ///< source cell of the element
  std::int64_t block = -1;  ///< flat index, of composite data
  // Only for the verdict Exact:
  Vec3 xi;
  double value = 0.0;         ///< of the visible component
  std::vector<double> values; ///< of all of the field's components
  std::string field;
};

/// The first visible sample along the ray, whose colour and actor are not fully transparent. The
/// ray is limited by near and far plane, or start and end, and by the mapper's clipping planes.
/// Throws Error. `view`: of the model; the function completes it. `ranges`: of the model's fields.
std::optional<PickedSample> Pick(Renderer& frames, View view, const HighOrderModel& model,
  const std::shared_ptr<FieldRanges>& ranges, const PickRay& ray, vtkMapper* mapper);
} // namespace pixelexact
