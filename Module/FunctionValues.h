// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactDataModelModule.h"

#include "Core/Math/Vec.h"

#include <span>

class vtkImplicitFunction;

// Evaluates vtkImplicitFunctions at many points at once, their transforms included. One thread at a
// time: functions keep data of their own while they are evaluated.
namespace pixelexact
{
/// Whether the function is a vtkImplicitCallback, or contains some in a vtkImplicitBoolean. Such a
/// function must be evaluated on the calling thread (Python callbacks).
PIXELEXACTDATAMODEL_EXPORT bool HasCallbacks(vtkImplicitFunction* function);

/// Evaluates callbacks once for all points, also in booleans. Throws Error with the message of a
/// callback that fails.
PIXELEXACTDATAMODEL_EXPORT void FunctionValues(
  vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values);

/// The rule of central differences.
struct DifferenceRule
{
  double step; ///< in world units
  Box3 box;    ///< they are one-sided at its faces
};

/// The function's own; of callbacks without a gradient, or moved by a transform, differences.
/// Throws as FunctionValues.
PIXELEXACTDATAMODEL_EXPORT void FunctionGradients(vtkImplicitFunction* function,
  const DifferenceRule& rule, std::span<const Vec3> x, std::span<Vec3> gradients);
} // namespace pixelexact
