// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Appearance/Appearance.h"
#include "Trace/Camera.h"
#include "Trace/Scene.h"
#include "Trace/Tracer.h"

#include <memory>
#include <vector>

// The description of one picture. Tool, Python, mappers, ParaView, compare and bench fill a View;
// Trace, Resolve and a Painter turn it into pixels, and a Renderer keeps what stays the same from
// one view to the next.
namespace pixelexact
{
/// What is cut, from where it is seen, and how it is drawn. A view holds objects and rules. The
/// numbers that rules give for a frame are a ResolvedAppearance. Equal views give equal pictures,
/// bit for bit.
struct View
{
  /// Owns the locator and the fields of the scene; null: they outlive the view.
  std::shared_ptr<const void> data;
  Scene scene;
  CameraSetup camera;
  Appearance appearance; ///< has as many layers as the scene
  /// Above 1: the middle pixel of each block of stride x stride pixels is traced, and all pixels of
  /// the block show it. Not with contours, edges and smooth edges, which need each pixel.
  int stride = 1;
};

/// Whether the rays of two views find the same: a frame of one has the samples of the other.
[[nodiscard]] bool HaveSameRays(const View& a, const View& b);

/// Sets Layer::translucent of all layers by what they look like. A layer is translucent where its
/// opacity is below 1 or its colour table has colours that are not opaque. `all`: all layers are,
/// because a window blends the frame over others. A plane that is the only layer is not: there is
/// nothing behind it.
void SetTranslucency(View& view, bool all = false);

/// The samples of the view's pixels, without colours: `centres` and those that Resolve and a
/// Painter read. Throws Error as Trace(Scene); aborted as it.
[[nodiscard]] Frame Trace(const View& view, Buffer centres, const Progress& progress = {});

/// Where the pixels of a scene lie, for a camera that is to show all of it; a small image is
/// enough. Pieces of elements that this makes are kept for the picture. Throws Error as Trace.
[[nodiscard]] std::vector<Vec3> SeenPoints(const Scene& scene, const CameraSetup& camera);
} // namespace pixelexact
