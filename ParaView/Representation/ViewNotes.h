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
/// What is written over a view's picture: what colours beside the map mean, and what the pixel
/// under the pointer shows, as long as no button is down.
class ViewNotes
{
public:
  /// `at`: the text of a pixel, counted from the lower left one; empty: nothing is there.
  explicit ViewNotes(std::function<std::string(int x, int y)> at);
  ~ViewNotes();
  ViewNotes(const ViewNotes&) = delete;
  ViewNotes& operator=(const ViewNotes&) = delete;

  void ShowLegend(bool show);
  void ShowPointer(bool show);
  /// Where a representation is hidden nothing is written.
  void SetVisible(bool visible);

  void AddTo(vtkPVRenderView* view);
  void RemoveFrom(vtkPVRenderView* view);
  /// Before each picture: the view may have got another interactor.
  void Watch(vtkPVRenderView* view);

  /// What is written of the pointer; empty: nothing.
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
