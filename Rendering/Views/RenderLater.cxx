// SPDX-License-Identifier: BSD-3-Clause
#include "Views/RenderLater.h"

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

namespace
{
constexpr unsigned long kMilliseconds = 1;
} // namespace

RenderLater::RenderLater()
{
  Command->SetClientData(this);
  Command->SetCallback(&RenderLater::Fired);
}

RenderLater::~RenderLater()
{
  this->Leave();
}

void RenderLater::Leave()
{
  if (Interactor)
  {
    Interactor->RemoveObserver(Observer);
  }
  Interactor = nullptr;
  Timer = Spent = 0;
}

void RenderLater::Ask(vtkRenderWindowInteractor* interactor)
{
  if (interactor != Interactor)
  {
    Leave();
    Interactor = interactor;
    Observer = interactor->AddObserver(vtkCommand::TimerEvent, Command);
  }
  if (Timer == 0)
  {
    Timer = interactor->CreateOneShotTimer(kMilliseconds);
  }
}

void RenderLater::Fired(vtkObject* /*caller*/, unsigned long /*event*/, void* self, void* timer)
{
  auto* const later = static_cast<RenderLater*>(self);
  if (timer == nullptr || later->Timer == 0 || *static_cast<int*>(timer) != later->Timer)
  {
    return;
  }
  if (later->Spent != 0)
  {
    // Destroys the previous timer, because VTK's timer loops do not allow the destruction of the
    // timer that fires.
    later->Interactor->DestroyTimer(later->Spent);
  }
  later->Spent = later->Timer;
  later->Timer = 0;
  later->Interactor->GetRenderWindow()->Render();
}
} // namespace pixelexact
