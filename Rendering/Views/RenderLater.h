// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWeakPointer.h"

#include <chrono>

class vtkRenderWindow;

namespace pixelexact
{
/// Invokes a window's AbortCheckEvent every 10 ms to check whether a frame is to be aborted.
/// vtkRenderWindow::CheckAbortStatus does so every 200 ms, which is a visible delay.
class AbortCheck
{
public:
  explicit AbortCheck(vtkRenderWindow* window)
    : Window(window)
  {
  }
  [[nodiscard]] bool IsAborted();

private:
  vtkRenderWindow* Window;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

/// Renders an interactor's window a second time, by a timer, after pending events have been
/// processed.
class RenderLater
{
public:
  RenderLater();
  ~RenderLater();
  RenderLater(const RenderLater&) = delete;
  RenderLater& operator=(const RenderLater&) = delete;

  /// Starts the timer. Has no effect while a timer is pending.
  void Ask(vtkRenderWindowInteractor* interactor);

private:
  static void Fired(vtkObject* caller, unsigned long event, void* self, void* timer);
  void Leave();

  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Observer = 0;
  int Timer = 0; ///< the running timer; 0: none
  int Spent = 0; ///< the previous timer
};
} // namespace pixelexact
