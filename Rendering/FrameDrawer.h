// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FrameCompositor.h"
#include "FrameSource.h"

#include <deque>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkRenderer;
class vtkWindow;

namespace pixelexact
{
/// What of a frame is drawn: what hides all behind it, what is seen through, or both.
enum class FramePart
{
  Opaque,
  Translucent,
  All
};

/// Frames from a FrameSource into a renderer, for one mapper.
class FrameDrawer
{
public:
  /// Draws a part of what `request` asks for, seen through the renderer's camera and placed by the
  /// actor. The request's camera, half-spaces and solid colour are filled in here: viewport and
  /// camera from the renderer, lights from the renderer, matrix from the actor, clipping planes and
  /// depth offset from the mapper. The actor's opacity is applied. Throws Error, after which there
  /// is no frame.
  void Draw(FrameRequest request, FramePart part, vtkRenderer* renderer, vtkActor* actor,
    vtkMapper* mapper, const Progress& progress);

  void ReleaseGraphicsResources(vtkWindow* window) { Compositor.ReleaseGraphicsResources(window); }

  [[nodiscard]] FrameSource& Source() { return TheSource; }

private:
  void Complete(FrameRequest& request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  /// The pixels of one or more sheets, ready to be drawn.
  struct Drawn
  {
    std::vector<std::uint8_t> rgba;
    std::vector<float> depths;
  };
  void MakeDrawn(const Frame& frame, const DepthRows& rows);

  FrameSource TheSource;
  FrameCompositor Compositor;
  Drawn Opaque;                  ///< rgba empty: the frame's own
  std::deque<Drawn> SeenThrough; ///< nearest first
  DepthRows Rows;
  std::int64_t DrawnVersion = -1; ///< of the source, that these were made of
  std::int64_t DrawnTrace = -1;
  std::int64_t DepthsVersion = 0;
};
} // namespace pixelexact
