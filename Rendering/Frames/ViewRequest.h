// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameCompositor.h"
#include "Frames/FrameSource.h"

#include <vector>

class vtkActor;
class vtkCamera;
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

/// How a camera sees a mapper's data, without a renderer.
struct CameraSight
{
  vtkCamera* camera = nullptr;
  vtkActor* actor = nullptr;
  vtkMapper* mapper = nullptr; ///< for its clipping planes
  int width = 0;               ///< pixels
  int height = 0;
  int stride = 1; ///< FrameRequest::stride
};

/// The same in the light of one headlight, with the actor's opacity and edges; the camera's
/// clipping range does not count. Throws Error where the actor's matrix has no inverse.
void CompleteRequest(const CameraSight& sight, FrameRequest& request);

/// The projection of OpenGL's geometry, from data space.
DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld);
} // namespace pixelexact
