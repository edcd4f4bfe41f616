// SPDX-License-Identifier: BSD-3-Clause
#include "Views/VtkLook.h"

#include "vtkCamera.h"
#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
Rgba ToRgba(const double rgb[3])
{
  Rgba color{ 0, 0, 0, 255 };
  std::transform(rgb, rgb + 3, color.begin(),
    [](double channel)
    { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(channel, 0.0, 1.0))); });
  return color;
}

Rgba ColorOf(vtkProperty* property)
{
  double rgb[3];
  property->GetDiffuseColor(rgb);
  return ToRgba(rgb);
}

std::optional<Material> MaterialOf(vtkProperty* property, bool solid)
{
  if (!property->GetLighting())
  {
    return std::nullopt;
  }
  Material material;
  material.ambient = property->GetAmbient();
  material.diffuse = property->GetDiffuse();
  material.specular = property->GetSpecular();
  material.specularPower = property->GetSpecularPower();
  property->GetSpecularColor(glm::value_ptr(material.specularColor));
  if (solid)
  {
    Vec3 color;
    property->GetAmbientColor(glm::value_ptr(color));
    material.ambientColor = color;
  }
  return material;
}

std::vector<Light> LightsOf(vtkRenderer* renderer)
{
  std::vector<Light> lights;
  vtkLightCollection* collection = renderer->GetLights();
  vtkCollectionSimpleIterator at;
  collection->InitTraversal(at);
  while (vtkLight* from = collection->GetNextLight(at))
  {
    if (!from->GetSwitch())
    {
      continue;
    }
    Light light;
    light.positional = from->GetPositional() != 0;
    light.headlight = from->LightTypeIsHeadlight() != 0;
    // VTK updates camera lights during rendering.
    Vec3 focus;
    from->GetTransformedPosition(glm::value_ptr(light.position));
    from->GetTransformedFocalPoint(glm::value_ptr(focus));
    const Vec3 way = focus - light.position;
    const double length = glm::length(way);
    light.direction = length > 0.0 ? way / length : Vec3(0.0, 0.0, -1.0);
    from->GetDiffuseColor(glm::value_ptr(light.color));
    light.color *= from->GetIntensity();
    from->GetAttenuationValues(glm::value_ptr(light.attenuation));
    light.coneAngle = from->GetConeAngle();
    light.exponent = from->GetExponent();
    lights.push_back(light);
  }
  return lights;
}

LitView LitViewOf(vtkCamera* camera, vtkMatrix4x4* dataToWorld)
{
  LitView view;
  camera->GetPosition(glm::value_ptr(view.eye));
  camera->GetDirectionOfProjection(glm::value_ptr(view.direction));
  view.parallel = camera->GetParallelProjection() != 0;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      view.linear[column][row] = dataToWorld->GetElement(row, column);
    }
    view.offset[row] = dataToWorld->GetElement(row, 3);
  }
  return view;
}

std::optional<EdgeStyle> EdgesOf(vtkProperty* property)
{
  if (!property->GetEdgeVisibility())
  {
    return std::nullopt;
  }
  return EdgeStyle::Plain(property->GetLineWidth(), ToRgba(property->GetEdgeColor()));
}
} // namespace pixelexact
