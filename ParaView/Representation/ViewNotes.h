// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCallbackCommand.h"
#include "vtkLegendBoxActor.h"
#include "vtkNew.h"
#include "vtkTextActor.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <string>

class vtkPVRenderView;
class vtkRenderWindowInteractor;

namespace pixelexact
{
/// Text over a view's picture: the meaning of colours outside the colour map, and the values of the
/// pixel under the pointer while no button is down.
class ViewNotes
{
public:
  /// `at`: returns the text of a pixel, counted from the lower left one; empty where nothing is
  /// shown.
  explicit ViewNotes(std::function<std::string(int x, int y)> at);
  ~ViewNotes();
  ViewNotes(const ViewNotes&) = delete;
  ViewNotes& operator=(const ViewNotes&) = delete;

  void ShowLegend(bool show);
  void ShowPointer(bool show);
  /// The legend says whether colours are a field's exact values or those of an array that is
  /// interpolated between points.
  void SetInterpolated(bool interpolated);
  /// A hidden representation writes no text.
  void SetVisible(bool visible);

  void AddTo(vtkPVRenderView* view);
  void RemoveFrom(vtkPVRenderView* view);
  /// Must be called before each picture, because the view may have got another interactor.
  void Watch(vtkPVRenderView* view);

  /// The text of the pixel under the pointer; empty where there is none.
  [[nodiscard]] const std::string& PointerText() const { return Text; }

private:
  static void Moved(vtkObject* caller, unsigned long event, void* self, void*);
  void Leave();
  void Update();

  std::function<std::string(int, int)> At;
  vtkNew<vtkLegendBoxActor> Legend;
  vtkNew<vtkTextActor> Pointer;
  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  std::string Text;
  bool HasLegend = false;
  bool HasPointer = false;
  bool Visible = true;
};
} // namespace pixelexact
