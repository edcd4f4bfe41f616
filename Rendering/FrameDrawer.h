// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FrameCompositor.h"
#include "FrameSource.h"

#include <deque>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkMatrix4x4;
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

/// Fills in what a view says of a request: camera, half-spaces, lights. `bounds` are those of the
/// data. Throws Error where the matrix has no inverse.
void CompleteRequest(const DataView& view, const Box3& bounds, FrameRequest& request);

/// The projection of OpenGL's geometry, from data space.
DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld);

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

  /// Draws what the present pass of the renderer's selector wants of the pixels that Draw shows
  /// (SelectionImage.h), complete in any case. Throws as Draw.
  void Select(FrameRequest request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper,
    const Progress& progress);

  void ReleaseGraphicsResources(vtkWindow* window);

  [[nodiscard]] FrameSource& Source() { return TheSource; }

private:
  const Frame& Render(FrameRequest& request, vtkRenderer* renderer, vtkActor* actor,
    vtkMapper* mapper, const Progress& progress);

  /// The pixels of one or more sheets, ready to be drawn.
  struct Drawn
  {
    std::vector<std::uint8_t> rgba;
    std::vector<float> depths;
  };
  void MakeDrawn(const Frame& frame, const DepthRows& rows);

  FrameSource TheSource;
  FrameCompositor Compositor;
  FrameCompositor Selection;     ///< keeps the textures of selectors' passes
  std::int64_t Selected = 0;     ///< passes drawn
  Drawn Opaque;                  ///< rgba empty: the frame's own
  std::deque<Drawn> SeenThrough; ///< nearest first
  DepthRows Rows;
  std::int64_t DrawnVersion = -1; ///< of the source, that these were made of
  std::int64_t DrawnTrace = -1;
  std::int64_t DepthsVersion = 0;
};
} // namespace pixelexact
