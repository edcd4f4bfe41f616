// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Camera.h"

#include <array>

class vtkCamera;
class vtkMatrix4x4;

// From VTK's cameras to rays. Wherever a view describes a camera, the rays come from that view
// alone, so that the mapper, the render pass and the command-line tool see the same points bit for
// bit, whatever clipping range VTK has chosen.
namespace pixelexact
{
/// True when a CameraView says all there is to say about the camera: no user or model transforms,
/// view shear, stereo, explicit projection or aspect ratio, nor off-axis projection.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT bool IsPlain(vtkCamera* camera);

/// World coordinates to normalised device coordinates (z in [-1, 1]), row-major, as OpenGL's
/// geometry is drawn: with the eye that stereo windows draw and the camera's model transform, which
/// vtkCamera::GetCompositeProjectionTransformMatrix leaves out.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::array<double, 16> WorldToDevice(
  vtkCamera* camera, double aspect);

/// The part of a camera that a CameraView holds.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView ViewOf(vtkCamera* camera);

/// Gives a camera the view; what a view does not hold keeps its value.
PIXELEXACTRENDERING_EXPORT void ApplyView(const CameraView& view, vtkCamera* camera);

/// The view as a vtkCamera that was given it hands it out: VTK scales the view-up to unit length.
/// For views that did not come from a camera, so that their rays are those of one, bit for bit; but
/// a focal point nearer than 1e-20, which VTK moves, stays where it is.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView AsHeld(const CameraView& view);

/// The rays of `camera` for a viewport of width x height pixels. `aspect` is the renderer's tiled
/// aspect ratio, 0: width / height. `dataToWorld` (an actor's matrix, may be null) moves the rays
/// into data space; a rotation, translation and uniform scale keep a view a view.
/// Throws Error when that matrix has no inverse.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraSetup SetupOf(vtkCamera* camera, int width,
  int height, double aspect = 0.0, vtkMatrix4x4* dataToWorld = nullptr);

/// The box as a whole in an image of width x height pixels, as vtkRenderer::ResetCamera frames it.
/// `towardsViewer` points from the box to the camera; it need not be of unit length. A `viewUp`
/// (nearly) parallel to it is replaced, as VTK does.
/// The view is one that a camera holds (AsHeld).
/// Throws Error when the box is empty or the direction is zero or not finite.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT CameraView ViewOfBox(const Box3& box,
  const Vec3& towardsViewer, int width, int height, const Vec3& viewUp = Vec3(0.0, 1.0, 0.0),
  bool parallel = false, double viewAngle = 30.0);
} // namespace pixelexact
