// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FramePick.h"

#include "Frames/ViewRequest.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"

#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Value of samples on a layer without a field.
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// An image of one pixel, with the ray through its centre.
CameraSetup CameraAlong(const Vec3& start, const Vec3& end)
{
  const Vec3 along = end - start;
  const Vec3 size = glm::abs(along);
  CameraView view;
  view.position = start;
  view.focalPoint = end;
  view.viewUp = size.x <= size.y && size.x <= size.z ? Vec3(1.0, 0.0, 0.0)
    : size.y <= size.z                               ? Vec3(0.0, 1.0, 0.0)
                                                     : Vec3(0.0, 0.0, 1.0);
  return { .rays = view, .width = 1, .height = 1 };
}

/// Completes the view for the ray and returns its sample's position in the image.
ImagePosition Aim(const PickRay& ray, vtkMapper* mapper, View& view)
{
  if (!ray.pixel)
  {
    CompleteAlong(CameraAlong(ray.start, ray.end), ray.opacity,
      ClippingPlanesOf(mapper, ray.dataToWorld), view);
    return { 0.5, 0.5 };
  }
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  ray.renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  Complete({ .renderer = ray.renderer,
             .mapper = mapper,
             .dataToWorld = ray.dataToWorld,
             .opacity = ray.opacity,
             .width = width,
             .height = height },
    view);
  return { (*ray.pixel)[0] + 0.5, (*ray.pixel)[1] + 0.5 };
}

bool Reaches(const PickRay& ray, const SampleBuffers& sheet)
{
  if (static_cast<PixelVerdict>(sheet.verdict[0]) == PixelVerdict::Nothing)
  {
    return false;
  }
  if (!ray.pixel)
  {
    return sheet.depth[0] <= glm::length(ray.end - ray.start);
  }
  std::vector<float> depth;
  WindowDepth(sheet, DepthRowsOf(ray.renderer, ray.dataToWorld), depth);
  return depth[0] <= 1.0F;
}

PickedSample Describe(
  const SampleBuffers& sheet, const std::vector<Layer>& layers, const HighOrderModel& model)
{
  PickedSample picked;
  picked.position = sheet.position[0];
  picked.normal = sheet.normal[0];
  picked.verdict = static_cast<PixelVerdict>(sheet.verdict[0]);
  picked.layer = sheet.layer[0];
  const Field* const field = layers[sheet.layer[0]].field;
  picked.field = field != nullptr ? field->name : "";
  if (picked.verdict != PixelVerdict::Exact)
  {
    return picked;
  }
  const std::int64_t element = sheet.element[0];
  picked.cell = element;
  picked.source = model.SourceCells()[static_cast<std::size_t>(element)];
  if (!model.Blocks().empty())
  {
    const HighOrderModel::Block& block = HighOrderModel::BlockOf(element, model.Blocks());
    picked.block = block.flatIndex;
    picked.cell -= block.begin;
  }
  picked.xi = sheet.xi[0];
  picked.value = sheet.value.empty() ? kNoValue : sheet.value[0];
  if (field != nullptr)
  {
    picked.values.resize(static_cast<std::size_t>(field->values.components));
    EvaluateAt(model.GetMesh(), *field, static_cast<int>(element), { &picked.xi, 1 }, picked.values,
      {}, { { &picked.position, 1 }, { &picked.normal, 1 } });
  }
  return picked;
}
} // namespace

std::optional<PickedSample> Pick(Renderer& frames, View view, const HighOrderModel& model,
  const std::shared_ptr<FieldRanges>& ranges, const PickRay& ray, vtkMapper* mapper)
{
  const ImagePosition position = Aim(ray, mapper, view);
  const SampleBuffers samples = frames.Sample(view, { &position, 1 }, ranges);
  const auto describe = [&](const SampleBuffers& sheet) -> std::optional<PickedSample>
  {
    if (!(ray.opacity > 0.0) || sheet.color[3] == 0 || !Reaches(ray, sheet))
    {
      return std::nullopt;
    }
    return Describe(sheet, view.scene.layers, model);
  };
  std::optional<PickedSample> picked = describe(samples);
  for (std::size_t k = 0; k < samples.behind.size() && !picked; ++k)
  {
    picked = describe(samples.behind[k]);
  }
  return picked;
}
} // namespace pixelexact
