// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkCallbackCommand;
class vtkMapper;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace pixelexact
{
/// The two rows of a projection matrix that give a depth: z and w of a point (x, 1).
struct DepthRows
{
  std::array<double, 4> z{};
  std::array<double, 4> w{};

  bool operator==(const DepthRows&) const = default;
};

/// Window depth of each pixel, in [0, 1], from its position; kNoDepth for pixels without a position
/// or beyond the far plane. Points that are before the near plane by rounding get its depth.
void WindowDepth(const SampleBuffers& samples, const DepthRows& rows, std::vector<float>& depth);
inline constexpr float kNoDepth = 2.0F;

/// Offset of depths, as VTK's mappers offset those of coincident polygons: factor times the
/// surface's slope (depth per pixel), plus units.
struct DepthOffset
{
  double factor = 0.0;
  double units = 0.0;
};

/// The pixels to draw. Versions are at least 0 and change with the arrays' contents.
struct Pixels
{
  const std::vector<std::uint8_t>& rgba; ///< straight alpha
  const std::vector<float>& depths;
  int sheet = 0; ///< number of the textures that keep the pixels between calls
  int width = 0;
  int height = 0;
  int step = 1; ///< each pixel is drawn as a block of step x step pixels
  double opacity = 1.0;
  DepthOffset offset;
  std::int64_t colorsVersion = 0;
  std::int64_t depthsVersion = 0;
};

/// Draws pixels with their depths into the framebuffer of OpenGL's geometry, so that the depth test
/// resolves visibility per pixel. One texel is one pixel: nothing is filtered, for any viewport,
/// number of samples or render pass.
class FrameCompositor
{
public:
  FrameCompositor();
  ~FrameCompositor();
  FrameCompositor(const FrameCompositor&) = delete;
  FrameCompositor& operator=(const FrameCompositor&) = delete;

  /// The viewport that OpenGL draws into: x, y, width, height. It differs from the renderer's if a
  /// pass renders to a framebuffer of its own (vtkSSAAPass).
  static std::array<int, 4> Viewport(vtkRenderer* renderer);

  /// Draws into the renderer's current framebuffer and viewport, which must have the size of the
  /// pixels' blocks; blocks at the right and upper edge may be cut off. In an actor's translucent
  /// phase, the colours go to the pass that sorts them (order-independent translucency, depth
  /// peeling).
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, const Pixels& pixels);

  /// Releases the textures and shaders of this window; null: of any window.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// The textures of a sheet.
  struct Textures
  {
    vtkNew<vtkTextureObject> colors;
    vtkNew<vtkTextureObject> depths;
    std::int64_t colorsVersion = -1; ///< of the contents, -1: none
    std::int64_t depthsVersion = -1;
  };
  vtkOpenGLQuadHelper* Quad(vtkActor* actor, vtkMapper* mapper);
  Textures& Upload(const Pixels& pixels);

  std::deque<Textures> Sheets;
  // Keyed by fragment shader, because render passes modify it.
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; ///< whose context holds the textures
  // A weak pointer is null when a window's destructor releases its resources.
  vtkNew<vtkCallbackCommand> BeforeDelete;
  unsigned long Observer = 0; ///< the window's
};
} // namespace pixelexact
