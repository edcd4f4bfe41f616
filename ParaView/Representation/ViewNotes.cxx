// SPDX-License-Identifier: BSD-3-Clause
#include "ViewNotes.h"

#include "vtkCommand.h"
#include "vtkInteractorStyle.h"
#include "vtkPVRenderView.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <utility>

namespace pixelexact
{
namespace
{
constexpr int kLetters = 14;
constexpr const char* kExact = "colour map: exact";
constexpr const char* kInterpolated = "colour map: interpolated, not the formula";

void MakeReadable(vtkTextProperty* text)
{
  // The text is readable on any background.
  text->SetFontSize(kLetters);
  text->SetColor(0.0, 0.0, 0.0);
  text->SetBackgroundColor(1.0, 1.0, 1.0);
  text->SetBackgroundOpacity(0.8);
}
} // namespace

ViewNotes::ViewNotes(std::function<std::string(int, int)> at)
  : At(std::move(at))
{
  Command->SetClientData(this);
  Command->SetCallback(&ViewNotes::Moved);
  MakeReadable(Pointer->GetTextProperty());
  Pointer->SetPosition(8, 8);
  vtkNew<vtkPlaneSource> square;
  square->Update();
  double magenta[3] = { 1.0, 0.0, 1.0 };
  double white[3] = { 1.0, 1.0, 1.0 };
  Legend->SetNumberOfEntries(3);
  vtkNew<vtkPolyData> none;
  none->SetPoints(vtkNew<vtkPoints>()); // the actor transforms them, none that are missing
  Legend->SetEntry(0, none, kExact, white);
  Legend->SetEntry(1, square->GetOutput(), "undecided", magenta);
  Legend->SetEntry(2, none, "background: nothing there", white);
  Legend->GetPositionCoordinate()->SetValue(0.02, 0.85);
  Legend->GetPosition2Coordinate()->SetValue(0.3, 0.13);
  Legend->UseBackgroundOn();
  double grey[3] = { 0.25, 0.25, 0.25 };
  Legend->SetBackgroundColor(grey);
  Legend->BorderOff();
  Update();
}

ViewNotes::~ViewNotes()
{
  Leave();
}

void ViewNotes::ShowLegend(bool show)
{
  HasLegend = show;
  Update();
}

void ViewNotes::ShowPointer(bool show)
{
  HasPointer = show;
  Text.clear();
  Update();
}

void ViewNotes::SetInterpolated(bool interpolated)
{
  Legend->SetEntryString(0, interpolated ? kInterpolated : kExact);
}

void ViewNotes::SetVisible(bool visible)
{
  Visible = visible;
  Update();
}

void ViewNotes::Update()
{
  Legend->SetVisibility(Visible && HasLegend);
  Pointer->SetVisibility(Visible && HasPointer && !Text.empty());
}

void ViewNotes::AddTo(vtkPVRenderView* view)
{
  // Adds the texts over the composited picture of all processes.
  view->GetNonCompositedRenderer()->AddActor(Legend);
  view->GetNonCompositedRenderer()->AddActor(Pointer);
}

void ViewNotes::RemoveFrom(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->RemoveActor(Legend);
  view->GetNonCompositedRenderer()->RemoveActor(Pointer);
  Leave();
}

void ViewNotes::Leave()
{
  if (Interactor)
  {
    Interactor->RemoveObserver(Command);
  }
  Interactor = nullptr;
}

void ViewNotes::Watch(vtkPVRenderView* view)
{
  vtkRenderWindowInteractor* const now = HasPointer ? view->GetInteractor() : nullptr;
  if (now != Interactor)
  {
    Leave();
    Interactor = now;
    if (now != nullptr)
    {
      now->AddObserver(vtkCommand::MouseMoveEvent, Command);
    }
  }
}

void ViewNotes::Moved(vtkObject* caller, unsigned long /*event*/, void* self, void* /*data*/)
{
  auto* const notes = static_cast<ViewNotes*>(self);
  auto* const interactor = static_cast<vtkRenderWindowInteractor*>(caller);
  auto* const style = vtkInteractorStyle::SafeDownCast(interactor->GetInteractorStyle());
  if (!notes->Visible || (style != nullptr && style->GetState() != VTKIS_NONE))
  {
    return;
  }
  const int* const at = interactor->GetEventPosition();
  std::string text = notes->At(at[0], at[1]);
  if (text != notes->Text)
  {
    notes->Text = std::move(text);
    notes->Pointer->SetInput(notes->Text.c_str());
    notes->Update();
    interactor->Render();
  }
}
} // namespace pixelexact
