// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FrameCompositor.h"
#include "FrameSource.h"

#include <vector>

class vtkActor;
class vtkMapper;
class vtkRenderer;
class vtkWindow;

namespace pixelexact
{
/// Frames from a FrameSource into a renderer, for one mapper.
class FrameDrawer
{
public:
  /// Draws what `request` asks for, seen through the renderer's camera and placed by the actor. The
  /// request's camera, half-spaces and solid colour are filled in here: viewport and camera from
  /// the renderer, matrix and colour from the actor, clipping planes from the mapper. The actor's
  /// opacity is applied. Throws Error, after which there is no frame.
  void Draw(FrameRequest request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper,
    const Progress& progress);

  void ReleaseGraphicsResources(vtkWindow* window) { Compositor.ReleaseGraphicsResources(window); }

  [[nodiscard]] FrameSource& Source() { return TheSource; }

private:
  void Complete(FrameRequest& request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  FrameSource TheSource;
  FrameCompositor Compositor;
  std::vector<float> Depths;
  DepthRows Rows;
  std::int64_t DepthsTrace = -1; ///< the trace that Depths belong to
  std::int64_t DepthsVersion = 0;
};
} // namespace pixelexact
