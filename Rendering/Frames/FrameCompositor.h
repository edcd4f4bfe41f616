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
/// The two rows of a projection matrix that make a depth: z and w of a point (x, 1).
struct DepthRows
{
  std::array<double, 4> z{};
  std::array<double, 4> w{};

  bool operator==(const DepthRows&) const = default;
};

/// Window depth of each pixel, in [0, 1], from its position; kNoDepth where there is none or the
/// point lies beyond the far plane. Points before the near plane by rounding come to lie on it.
void WindowDepth(const SampleBuffers& samples, const DepthRows& rows, std::vector<float>& depth);
inline constexpr float kNoDepth = 2.0F;

/// By how much depths are moved, as VTK's mappers move those of coincident polygons: factor times
/// the surface's slope, in depth per pixel, and so many units.
struct DepthOffset
{
  double factor = 0.0;
  double units = 0.0;
};

/// What is drawn. Versions are at least 0 and change with the arrays' contents.
struct Pixels
{
  const std::vector<std::uint8_t>& rgba; ///< straight alpha
  const std::vector<float>& depths;
  int sheet = 0; ///< whose textures hold them from call to call
  int width = 0;
  int height = 0;
  int step = 1; ///< each is drawn as a block of step x step pixels
  double opacity = 1.0;
  DepthOffset offset;
  std::int64_t colorsVersion = 0;
  std::int64_t depthsVersion = 0;
};

/// Puts pixels and their depths into the framebuffer beside what OpenGL draws there, so that either
/// hides the other by depth, to the pixel. One texel is one pixel: no filtering, whatever the
/// viewport, the number of samples or the pass that binds the framebuffer.
class FrameCompositor
{
public:
  FrameCompositor();
  ~FrameCompositor();
  FrameCompositor(const FrameCompositor&) = delete;
  FrameCompositor& operator=(const FrameCompositor&) = delete;

  /// The viewport that OpenGL draws into: x, y, width, height. Not the renderer's where a pass
  /// renders to a framebuffer of its own (vtkSSAAPass).
  static std::array<int, 4> Viewport(vtkRenderer* renderer);

  /// Draws into the renderer's current framebuffer and viewport, which must have the size of the
  /// pixels' blocks; those at the right and upper edge may be cut off.
  /// With an actor in its translucent phase the colours go to whatever pass sorts them there
  /// (order-independent translucency, depth peeling).
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, const Pixels& pixels);

  /// What is held for this window; null: for any.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// What the graphics card holds of a sheet.
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
  // By fragment shader: passes have their say in it.
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; ///< whose context holds the textures
  // Weak pointers are null when a window's destructor has its resources released.
  vtkNew<vtkCallbackCommand> BeforeDelete;
  unsigned long Observer = 0; ///< the window's
};
} // namespace pixelexact
