// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/SearchedSurface.h"

#include "vtkSmartPointer.h"

#include <mutex>

class vtkImplicitFunction;

namespace pixelexact
{
/// A vtkImplicitFunction, its transform included, asked for many points at once and by one thread
/// at a time: functions keep data of their own while they are evaluated. One that is a
/// vtkImplicitCallback, or is made of some by vtkImplicitBoolean, is asked by the calling thread
/// alone.
class VtkSampledFunction final : public SampledFunction
{
public:
  /// `box`: where it is asked.
  VtkSampledFunction(vtkImplicitFunction* function, const Box3& box);
  ~VtkSampledFunction() override;

  /// Throws Error where a callback fails.
  void Evaluate(std::span<const Vec3> x, std::span<double> values) const override;
  /// The function's own; of callbacks without a gradient, or moved by a transform, central
  /// differences within the box, over 6e-6 of its size.
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override;
  [[nodiscard]] bool NeedsCallingThread() const override { return HasCallbacks; }

private:
  vtkSmartPointer<vtkImplicitFunction> Function;
  Box3 Box;
  bool HasCallbacks;
  mutable std::mutex Mutex;
};
} // namespace pixelexact
