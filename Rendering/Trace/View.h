// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Appearance.h"
#include "Trace/Camera.h"
#include "Trace/Scene.h"
#include "Trace/Tracer.h"
#include "Trace/Volume/Volume.h"

#include <memory>
#include <optional>
#include <vector>

// The description of one picture. Tool, Python, mappers, ParaView, compare and bench fill a View.
// Trace, Resolve and a Painter convert it to pixels. A Renderer keeps results that the next view
// shares.
namespace pixelexact
{
/// Scene, camera and appearance. A view holds objects and rules; ResolvedAppearance has the numbers
/// that rules give for a frame. Equal views give equal pictures, bit for bit.
struct View
{
  /// Owns the locator and the fields of the scene; null: they outlive the view.
  std::shared_ptr<const void> data;
  Scene scene;
  CameraSetup camera;
  Appearance appearance; ///< has as many layers as the scene
  /// Above 1: the middle pixel of each block of stride x stride pixels is traced, and all pixels of
  /// the block show it. Excludes contours, edges and anti-aliasing, which need each pixel.
  int stride = 1;
  /// Drawn between the surfaces. Excludes anti-aliasing, and with translucent layers also lines. A
  /// scene that has nothing else has a layer of NoSurface.
  std::optional<Volume> volume{};
};

/// The rays of both views find the same hits, so a frame of one has the samples of the other.
[[nodiscard]] bool HaveSameRays(const View& a, const View& b);

/// Sets Layer::translucent of all layers. A layer is translucent if its opacity is below 1 or its
/// colour table has colours that are not opaque. `all`: all layers are translucent, because a
/// window blends the frame over others. A plane that is the only layer is never translucent,
/// because it has nothing behind it.
void SetTranslucency(View& view, bool all = false);

/// Traces the samples of the view's pixels, without colours: the buffers `centres`, and those that
/// Resolve and a Painter read. Throws Error and aborts as Trace(Scene).
[[nodiscard]] Frame Trace(const View& view, Buffer centres, const Progress& progress = {});

/// The positions of a scene's visible pixels, for a camera that shows all of the scene; a small
/// image suffices. Pieces of elements that are computed here are kept for the picture. Throws Error
/// as Trace.
[[nodiscard]] std::vector<Vec3> SeenPoints(const Scene& scene, const CameraSetup& camera);
} // namespace pixelexact
