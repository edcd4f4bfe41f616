// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameCompositor.h"
#include "Trace/View.h"

#include <vector>

class vtkActor;
class vtkCamera;
class vtkMapper;
class vtkMatrix4x4;
class vtkRenderer;

// Converts the camera and lights of a renderer, and the place of an actor, to a view.
namespace pixelexact
{
/// How a renderer shows a mapper's data.
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

/// Completes a view that has its data, layers, contours and edges: sets camera, half-spaces, lights
/// and translucency. Throws Error if the matrix has no inverse.
void Complete(const DataView& seen, View& view);

/// How a camera shows a mapper's data, without a renderer.
struct CameraSight
{
  vtkCamera* camera = nullptr;
  vtkActor* actor = nullptr;
  vtkMapper* mapper = nullptr; ///< for its clipping planes
  int width = 0;               ///< pixels
  int height = 0;
  int stride = 1; ///< View::stride
};

/// The same, with one headlight and the actor's opacity and edges. Ignores the camera's clipping
/// range. Throws Error if the actor's matrix has no inverse.
void Complete(const CameraSight& seen, View& view);

/// Completes a view that is traced along a single ray.
void CompleteAlong(
  const CameraSetup& ray, double opacity, std::vector<KeptHalfSpace> kept, View& view);

/// The projection of OpenGL's geometry, from data space.
DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld);
} // namespace pixelexact
