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

// Converts VTK's lights and properties.
namespace pixelexact
{
/// An opaque colour from red, green and blue, 0 to 1.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Rgba ToRgba(const double rgb[3]);

/// The property's diffuse colour, opaque.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Rgba ColorOf(vtkProperty* property);

/// None if the property switches lighting off. Ambient light has the sample's colour, as in VTK
/// with mapped scalars, or, with `solid`, the property's ambient colour.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::optional<Material> MaterialOf(
  vtkProperty* property, bool solid);

/// The renderer's lights that are switched on, in world coordinates.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::vector<Light> LightsOf(vtkRenderer* renderer);

/// The camera for samples in data space. `dataToWorld`: the actor's matrix.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT LitView LitViewOf(
  vtkCamera* camera, vtkMatrix4x4* dataToWorld);

/// Style of the lines between elements; none unless the property makes edges visible.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::optional<EdgeStyle> EdgesOf(vtkProperty* property);
} // namespace pixelexact
