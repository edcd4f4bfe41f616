// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <functional>
#include <string>
#include <utility>

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

class vtkRenderWindowInteractor;
class vtkSliderRepresentation2D;
class vtkSliderWidget;

namespace pixelexact
{
/// Calls a function at an event. The function object lives as long as the observed object.
template <class Function>
void Observe(vtkObject* object, unsigned long event, Function function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Function(std::move(function)));
  command->SetClientDataDeleteCallback([](void* client) { delete static_cast<Function*>(client); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { (*static_cast<Function*>(client))(); });
  object->AddObserver(event, command);
}

/// A slider over time steps.
class StepSlider
{
public:
  StepSlider();
  ~StepSlider();
  StepSlider(const StepSlider&) = delete;
  StepSlider& operator=(const StepSlider&) = delete;

  /// `moved` is called with the step when the slider is released.
  void AddTo(vtkRenderWindowInteractor* interactor, int steps, std::function<void(int)> moved);
  void Set(int step);

private:
  vtkNew<vtkSliderWidget> Slider;
  vtkNew<vtkSliderRepresentation2D> Shape;
};

/// Texts over a window's picture: a status line, the keys, the colour bar.
class ViewTexts
{
public:
  ViewTexts();
  ~ViewTexts();
  ViewTexts(const ViewTexts&) = delete;
  ViewTexts& operator=(const ViewTexts&) = delete;

  /// `table` null: there is no bar.
  void AddTo(vtkRenderer& renderer, vtkLookupTable* table, const std::string& field);
  void Tell(const std::string& text);
  /// Switches between the help and the key that shows it.
  void TurnHelp();
  void SetTable(vtkLookupTable* table);

private:
  void ShowHelp();

  bool Help = false;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> HelpText;
};
} // namespace pixelexact
