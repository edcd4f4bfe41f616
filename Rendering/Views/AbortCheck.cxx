// SPDX-License-Identifier: BSD-3-Clause
#include "Views/AbortCheck.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"

namespace pixelexact
{
bool AbortCheck::IsAborted()
{
  const auto now = std::chrono::steady_clock::now();
  if (Window->GetInAbortCheck() == 0 && now - Last >= std::chrono::milliseconds(10))
  {
    Last = now;
    Window->SetInAbortCheck(1);
    Window->InvokeEvent(vtkCommand::AbortCheckEvent, nullptr);
    Window->SetInAbortCheck(0);
  }
  return Window->GetAbortRender() != 0;
}
} // namespace pixelexact
