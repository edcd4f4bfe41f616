// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>

class vtkImplicitFunction;

namespace pixelexact
{
/// Where surfaces without a closed form are searched for, and how: see SearchedSurface.
struct SurfaceSearch
{
  Box3 box{ Vec3(0.0), Vec3(-1.0) }; ///< empty: they are refused
  int samples = 128;                 ///< on the part of a ray in the box
};

/// The cut-surface f(x) = 0 of a vtkImplicitFunction, its transform included.
///
/// In closed form, copies that later changes do not reach: vtkPlane, vtkSphere, vtkCylinder,
/// vtkCone (both halves), vtkQuadric, vtkBox, vtkPlanes, vtkImplicitTorus, and vtkImplicitBoolean
/// of these; a plane moved by any homogeneous transform, the others, but for the torus, by affine
/// ones. Any other function or transform is searched for, and asked whenever rays are traced.
///
/// Throws Error for impossible parameters, such as a normal of length zero, for an empty boolean,
/// and for a union of magnitudes; Unsupported, naming the class, for what would have to be searched
/// for without a box.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> ToSurface(
  vtkImplicitFunction* function, const SurfaceSearch& search = {});
} // namespace pixelexact
