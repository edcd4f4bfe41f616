// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/SearchedSurface.h"

#include "vtkSmartPointer.h"

#include <mutex>

class vtkImplicitFunction;

namespace pixelexact
{
/// A vtkImplicitFunction with its transform, evaluated at many points per call and by one thread at
/// a time, because functions change internal data during evaluation. A vtkImplicitCallback, or a
/// vtkImplicitBoolean that contains one, is evaluated on the calling thread only.
class VtkSampledFunction final : public SampledFunction
{
public:
  /// `box`: the region of evaluation.
  VtkSampledFunction(vtkImplicitFunction* function, const Box3& box);
  ~VtkSampledFunction() override;

  /// Throws Error if a callback fails.
  void Evaluate(std::span<const Vec3> x, std::span<double> values) const override;
  /// The function's own gradients. For callbacks without a gradient, or with a transform, central
  /// differences in the box with a step of 6e-6 of its size.
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override;
  [[nodiscard]] bool NeedsCallingThread() const override { return HasCallbacks; }

private:
  vtkSmartPointer<vtkImplicitFunction> Function;
  Box3 Box;
  bool HasCallbacks;
  mutable std::mutex Mutex;
};
} // namespace pixelexact
