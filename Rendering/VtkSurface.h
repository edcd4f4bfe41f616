// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>

class vtkImplicitFunction;

namespace pixelexact
{
/// The cut-surface f(x) = 0 of a vtkImplicitFunction, its transform included. A copy: later changes
/// of the function do not reach it.
///
/// Available are vtkPlane, vtkSphere, vtkCylinder, vtkCone (both halves), vtkQuadric, vtkBox,
/// vtkPlanes and vtkImplicitTorus; a plane moved by any homogeneous transform, the others by affine
/// ones. Throws Unsupported, naming the class and what there is, for another function or transform;
/// Error for impossible parameters, such as a normal of length zero.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> ToSurface(
  vtkImplicitFunction* function);
} // namespace pixelexact
