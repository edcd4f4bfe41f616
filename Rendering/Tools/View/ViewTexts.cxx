// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewTexts.h"

#include <vtkCommand.h>
#include <vtkLookupTable.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
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

namespace
{
constexpr int kLetters = 15;

constexpr const char* kHelp =
  "drag        turn, shift: move, wheel: nearer\n"
  "p           handles on, off: drag the cut, or its arrow\n"
  "            (plane, sphere, cylinder, box; sphere's radius: right button)\n"
  "c           contours\n"
  "e           edges of elements\n"
  "r           colours over what is seen\n"
  "left, right time step\n"
  "s           save the exact figure\n"
  "h           this help\n"
  "q           close";

void SetLetters(vtkTextActor& text)
{
  text.SetInput("");
  text.GetTextProperty()->SetFontSize(kLetters);
  text.GetTextProperty()->SetColor(0.0, 0.0, 0.0);
  text.GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  text.GetTextProperty()->SetBackgroundOpacity(0.75);
}
} // namespace

ViewTexts::ViewTexts() = default;
ViewTexts::~ViewTexts() = default;

void ViewTexts::AddTo(vtkRenderer& renderer, vtkLookupTable* table, const std::string& field)
{
  SetLetters(*HelpText);
  SetLetters(*Status);
  HelpText->GetTextProperty()->SetFontFamilyToCourier();
  HelpText->GetTextProperty()->SetVerticalJustificationToTop();
  HelpText->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  HelpText->GetPositionCoordinate()->SetValue(0.01, 0.99);
  Status->SetDisplayPosition(10, 10);
  ShowHelp();
  renderer.AddViewProp(HelpText);
  renderer.AddViewProp(Status);
  if (table == nullptr)
  {
    return;
  }
  Bar->SetLookupTable(table);
  Bar->SetTitle(field.c_str());
  Bar->SetNumberOfLabels(5);
  Bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* text : { Bar->GetTitleTextProperty(), Bar->GetLabelTextProperty() })
  {
    text->SetColor(0.0, 0.0, 0.0);
    text->SetFontSize(kLetters);
    text->ShadowOff();
    text->ItalicOff();
    text->BoldOff();
  }
  renderer.AddViewProp(Bar);
}

void ViewTexts::Tell(const std::string& text)
{
  Status->SetInput(text.c_str());
}

void ViewTexts::TurnHelp()
{
  Help = !Help;
  ShowHelp();
}

void ViewTexts::ShowHelp()
{
  HelpText->SetInput(Help ? kHelp : "h: help");
}

void ViewTexts::SetTable(vtkLookupTable* table)
{
  Bar->SetLookupTable(table);
}
} // namespace pixelexact
