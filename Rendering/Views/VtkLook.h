// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Modules/ElementEdges.h"
#include "Trace/Modules/Lighting.h"

#include <optional>
#include <vector>

class vtkCamera;
class vtkMatrix4x4;
class vtkProperty;
class vtkRenderer;

// From VTK's lights and properties to ours.
namespace pixelexact
{
/// Red, green and blue from 0 to 1, opaque.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Rgba ToRgba(const double rgb[3]);

/// The property's colour of diffuse light, opaque.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Rgba ColorOf(vtkProperty* property);

/// None where the property switches lighting off. Ambient light is in the sample's own colour, as
/// in VTK where scalars are mapped, or else, with `solid`, in the property's.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::optional<Material> MaterialOf(
  vtkProperty* property, bool solid);

/// The renderer's lights that are switched on, in world coordinates.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<Light> LightsOf(vtkRenderer* renderer);

/// The camera, for samples in the space that `dataToWorld` leads from.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT LitView LitViewOf(
  vtkCamera* camera, vtkMatrix4x4* dataToWorld);

/// Lines between elements, where the property makes edges visible.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::optional<EdgeStyle> EdgesOf(vtkProperty* property);
} // namespace pixelexact
