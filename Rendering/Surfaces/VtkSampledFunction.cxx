// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkSampledFunction.h"

#include "FunctionValues.h"

#include "vtkImplicitFunction.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Step relative to the box's size: the cube root of the unit roundoff is optimal for central
/// differences.
constexpr double kStep = 6e-6;
} // namespace

VtkSampledFunction::VtkSampledFunction(vtkImplicitFunction* function, const Box3& box)
  : Function(function)
  , Box(box)
  , HasCallbacks(pixelexact::HasCallbacks(function))
{
}

VtkSampledFunction::~VtkSampledFunction() = default;

void VtkSampledFunction::Evaluate(std::span<const Vec3> x, std::span<double> values) const
{
  const std::scoped_lock lock(Mutex);
  FunctionValues(Function, x, values);
}

void VtkSampledFunction::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  const std::scoped_lock lock(Mutex);
  const Vec3 size = Box.upper - Box.lower;
  const DifferenceRule rule{ kStep * std::max({ size.x, size.y, size.z }), Box };
  FunctionGradients(Function, rule, x, gradients);
}
} // namespace pixelexact
