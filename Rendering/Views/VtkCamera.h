// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"

#include <array>

class vtkCamera;
class vtkMatrix4x4;

// Converts VTK's cameras to rays. If a view describes a camera, the rays depend on that view alone.
// So the mapper, the render pass and the command-line tool get the same points, bit for bit, for
// any clipping range of VTK.
namespace pixelexact
{
/// A CameraView describes the camera completely: it has no user or model transforms, view shear,
/// stereo, explicit projection or aspect ratio, or off-axis projection.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT bool IsPlain(vtkCamera* camera);

/// The matrix from world coordinates to normalised device coordinates (z in [-1, 1]), row-major, as
/// for OpenGL's geometry. It includes the current eye of stereo windows and the camera's model
/// transform, which vtkCamera::GetCompositeProjectionTransformMatrix omits.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::array<double, 16> WorldToDevice(
  vtkCamera* camera, double aspect);

/// The part of a camera that a CameraView describes.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView ViewOf(vtkCamera* camera);

/// Sets a camera to the view; settings outside the view are kept.
PIXELEXACTRENDERING_EXPORT void ApplyView(const CameraView& view, vtkCamera* camera);

/// The view after a round trip through a vtkCamera, which scales view-up to unit length. It makes
/// rays of views that did not come from a camera equal to those of one, bit for bit. Exception: a
/// focal point nearer than 1e-20, which VTK moves, is kept.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView AsHeld(const CameraView& view);

/// The rays of `camera` for a viewport of width x height pixels. `aspect`: the renderer's tiled
/// aspect ratio; 0: width / height. `dataToWorld`: an actor's matrix, or null; it moves the rays to
/// data space. Under a rotation, translation and uniform scale the result is still a view. Throws
/// Error if the matrix has no inverse.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraSetup SetupOf(vtkCamera* camera, int width,
  int height, double aspect = 0.0, vtkMatrix4x4* dataToWorld = nullptr);

/// A view of the whole box in an image of width x height pixels, framed as by
/// vtkRenderer::ResetCamera. `towardsViewer`: direction from the box to the camera, of any length.
/// A `viewUp` that is nearly parallel to it is replaced, as VTK does. The view is one that a
/// vtkCamera can hold (AsHeld). Throws Error if the box is empty or the direction is zero or not
/// finite.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView ViewOfBox(const Box3& box,
  const Vec3& towardsViewer, int width, int height, const Vec3& viewUp = Vec3(0.0, 1.0, 0.0),
  bool parallel = false, double viewAngle = 30.0);
} // namespace pixelexact
