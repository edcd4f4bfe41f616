// SPDX-License-Identifier: BSD-3-Clause
#include "View/StepSlider.h"

#include "View/Observe.h"

#include <vtkCommand.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <utility>

namespace pixelexact
{
StepSlider::StepSlider() = default;
StepSlider::~StepSlider() = default;

void StepSlider::AddTo(
  vtkRenderWindowInteractor* interactor, int steps, std::function<void(int)> moved)
{
  Shape->SetMinimumValue(0.0);
  Shape->SetMaximumValue(steps - 1.0);
  Shape->SetTitleText("time step");
  Shape->SetLabelFormat("%.0f");
  Shape->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  Shape->GetPoint1Coordinate()->SetValue(0.35, 0.06);
  Shape->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  Shape->GetPoint2Coordinate()->SetValue(0.65, 0.06);
  for (vtkTextProperty* text : { Shape->GetTitleProperty(), Shape->GetLabelProperty() })
  {
    text->SetColor(0.0, 0.0, 0.0);
    text->ShadowOff();
  }
  Shape->GetTubeProperty()->SetColor(0.6, 0.6, 0.6);
  Shape->GetSliderProperty()->SetColor(0.2, 0.2, 0.2);
  Shape->GetCapProperty()->SetColor(0.6, 0.6, 0.6);
  Slider->SetInteractor(interactor);
  Slider->SetRepresentation(Shape);
  Observe(Slider, vtkCommand::EndInteractionEvent,
    [this, moved = std::move(moved)] { moved(static_cast<int>(std::lround(Shape->GetValue()))); });
  Slider->On();
}

void StepSlider::Set(int step)
{
  Shape->SetValue(step);
}
} // namespace pixelexact
