// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <memory>

class vtkImplicitBoolean;
class vtkImplicitFunction;

// Cut-surfaces of VTK's functions without a closed form of their own.
namespace pixelexact
{
/// Converts a function that is not a boolean to a surface in closed form; null if there is none.
using ClosedForm = std::function<std::shared_ptr<const Surface>(vtkImplicitFunction*)>;

/// Combines the hits of a boolean's functions, which may be booleans, if all of them have closed
/// forms. Null if one has none, or if a boolean has a transform. Throws Error for a boolean without
/// functions, and for a union of magnitudes, which never changes its sign.
[[nodiscard]] std::shared_ptr<const Surface> FromBoolean(
  vtkImplicitBoolean* boolean, const ClosedForm& closedForm);

/// A surface for any function, by a search in a box with `samples` samples (SearchedSurface). The
/// function itself is evaluated (VtkSampledFunction).
[[nodiscard]] std::shared_ptr<const Surface> FromAnyFunction(
  vtkImplicitFunction* function, const Box3& box, int samples);
} // namespace pixelexact
