// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Surface.h"

#include <memory>

class vtkImplicitFunction;

namespace pixelexact
{
/// The cut-surface f(x) = 0 of a vtkImplicitFunction, its transform included. A copy: later changes
/// of the function do not reach it.
///
/// Throws Unsupported, naming the class and what there is, for a function of another kind than
/// vtkPlane or with a transform under which that is none; Error for impossible parameters, such as
/// a normal of length zero.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT std::shared_ptr<const Surface> ToSurface(
  vtkImplicitFunction* function);
} // namespace pixelexact
