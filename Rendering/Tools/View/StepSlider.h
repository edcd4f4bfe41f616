// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <functional>

class vtkRenderWindowInteractor;
class vtkSliderRepresentation2D;
class vtkSliderWidget;

namespace pixelexact
{
/// A slider over time steps.
class StepSlider
{
public:
  StepSlider();
  ~StepSlider();
  StepSlider(const StepSlider&) = delete;
  StepSlider& operator=(const StepSlider&) = delete;

  /// `moved`: called with the step where it was let go.
  void AddTo(vtkRenderWindowInteractor* interactor, int steps, std::function<void(int)> moved);
  void Set(int step);

private:
  vtkNew<vtkSliderWidget> Slider;
  vtkNew<vtkSliderRepresentation2D> Shape;
};
} // namespace pixelexact
