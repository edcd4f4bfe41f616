// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewStyle.h"

#include "View/ViewWindow.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <string>

namespace pixelexact
{
vtkStandardNewMacro(ViewStyle);

void ViewStyle::OnChar()
{
  const char* symbol = Interactor->GetKeySym();
  const std::string key = symbol != nullptr ? symbol : "";
  if (key == "q" || key == "Escape")
  {
    Interactor->ExitCallback();
  }
  else
  {
    Window->Press(key);
  }
}

void ViewStyle::OnLeftButtonDown()
{
  if (!Window->Grab())
  {
    Superclass::OnLeftButtonDown();
  }
}

void ViewStyle::OnLeftButtonUp()
{
  if (!Window->Release())
  {
    Superclass::OnLeftButtonUp();
  }
}

void ViewStyle::OnMiddleButtonDown()
{
  if (Window->IsInPicture())
  {
    Superclass::OnMiddleButtonDown();
  }
}

void ViewStyle::OnRightButtonDown()
{
  if (Window->IsInPicture())
  {
    Superclass::OnRightButtonDown();
  }
}

void ViewStyle::OnMouseWheelForward()
{
  if (!Window->Scroll(-1))
  {
    Superclass::OnMouseWheelForward();
  }
}

void ViewStyle::OnMouseWheelBackward()
{
  if (!Window->Scroll(1))
  {
    Superclass::OnMouseWheelBackward();
  }
}

void ViewStyle::OnMouseMove()
{
  if (Window->Drag())
  {
    return;
  }
  if (GetState() == VTKIS_NONE)
  {
    Window->Hover();
  }
  Superclass::OnMouseMove();
}
} // namespace pixelexact
