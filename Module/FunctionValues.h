// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactDataModelModule.h"

#include "Core/Math/Vec.h"

#include <span>

class vtkImplicitFunction;

// vtkImplicitFunctions asked for many points at once, their transforms included. By one thread at a
// time: functions keep data of their own while they are evaluated.
namespace pixelexact
{
/// Whether it is a vtkImplicitCallback, or made of some by vtkImplicitBoolean: only the calling
/// thread may ask it.
PIXELEXACTDATAMODEL_EXPORT bool HasCallbacks(vtkImplicitFunction* function);

/// Callbacks are asked once for all points, in booleans too. Throws Error with the words of a
/// callback that fails.
PIXELEXACTDATAMODEL_EXPORT void FunctionValues(
  vtkImplicitFunction* function, std::span<const Vec3> x, std::span<double> values);

/// Where central differences are taken.
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
