// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FrameCompositor.h"
#include "FrameSource.h"

#include <vector>

class vtkMapper;
class vtkMatrix4x4;
class vtkRenderer;

// What a renderer's view of a mapper's data says of a request for frames.
namespace pixelexact
{
/// How a mapper's data are seen.
struct DataView
{
  vtkRenderer* renderer = nullptr;
  vtkMapper* mapper = nullptr; ///< for its clipping planes
  vtkMatrix4x4* dataToWorld = nullptr;
  double opacity = 1.0; ///< of the actor
  int width = 0;        ///< pixels
  int height = 0;
};

/// The mapper's clipping planes, in the data's coordinates.
std::vector<KeptHalfSpace> ClippingPlanesOf(vtkMapper* mapper, vtkMatrix4x4* dataToWorld);

/// Fills in what a view says of a request: camera, half-spaces, lights. Throws Error where the
/// matrix has no inverse.
void CompleteRequest(const DataView& view, FrameRequest& request);

/// The projection of OpenGL's geometry, from data space.
DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld);
} // namespace pixelexact
