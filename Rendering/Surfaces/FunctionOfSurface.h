// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"

#include "vtkSmartPointer.h"

class vtkImplicitFunction;

namespace pixelexact
{
class Surface;

/// The implicit function of a plane, quadric, torus or axis-aligned box, for VTK's own filters;
/// null for other surfaces. A quadric's function is moved near its centre by a transform, so that
/// distant ones keep their digits.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkImplicitFunction> FunctionOf(
  const Surface& surface);
} // namespace pixelexact
