// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <memory>

class vtkImplicitBoolean;
class vtkImplicitFunction;

// Cut-surfaces of VTK's functions that have no closed form of their own.
namespace pixelexact
{
/// The surface in closed form of a function that is no boolean; null where there is none.
using ClosedForm = std::function<std::shared_ptr<const Surface>(vtkImplicitFunction*)>;

/// A boolean, of booleans too, whose functions all have closed forms: from their own hits; null
/// where one has not, or where a boolean is moved by a transform. Throws Error for one without
/// functions, and for a union of magnitudes, which changes its sign nowhere.
[[nodiscard]] std::shared_ptr<const Surface> FromBoolean(
  vtkImplicitBoolean* boolean, const ClosedForm& closedForm);

/// Any function, by a search in a box (SearchedSurface) with so many samples. The function itself
/// is asked (VtkSampledFunction).
[[nodiscard]] std::shared_ptr<const Surface> FromAnyFunction(
  vtkImplicitFunction* function, const Box3& box, int samples);
} // namespace pixelexact
