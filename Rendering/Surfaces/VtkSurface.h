// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surfaces/Surface.h"

#include <memory>

class vtkImplicitFunction;

namespace pixelexact
{
/// Box and sample count of the search for surfaces without a closed form; see SearchedSurface.
struct SurfaceSearch
{
  Box3 box{ Vec3(0.0), Vec3(-1.0) }; ///< empty: such surfaces are refused
  int samples = 128;                 ///< per ray, on its part in the box
};

/// The cut-surface f(x) = 0 of a vtkImplicitFunction with its transform.
///
/// These functions are copied to closed forms, which later changes do not affect: vtkPlane,
/// vtkSphere, vtkCylinder, vtkCone (double cone), vtkQuadric, vtkBox, vtkPlanes, vtkImplicitTorus,
/// and vtkImplicitBoolean of these. A plane may have any homogeneous transform, the others except
/// the torus an affine one. Surfaces of other functions or transforms are searched, and the
/// function is evaluated whenever rays are traced.
///
/// Throws Error for impossible parameters, such as a normal of length zero, for an empty boolean,
/// and for a union of magnitudes. Throws Unsupported, naming the class, for a function that needs a
/// search if there is no box.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> ToSurface(
  vtkImplicitFunction* function, const SurfaceSearch& search = {});
} // namespace pixelexact
