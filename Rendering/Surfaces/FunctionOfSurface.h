// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"

#include "vtkSmartPointer.h"

class vtkImplicitFunction;

namespace pixelexact
{
class Surface;

/// The function whose zeros a plane, quadric, torus or box along the axes is, for VTK's own
/// filters; null of other surfaces. A quadric's is moved by a transform to near its centre, so that
/// far ones keep their digits.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT vtkSmartPointer<vtkImplicitFunction> FunctionOf(
  const Surface& surface);
} // namespace pixelexact
