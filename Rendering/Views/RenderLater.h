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
/// Asks a window's observers of AbortCheckEvent whether a frame is to be ended, every 10 ms.
/// vtkRenderWindow::CheckAbortStatus asks them every 200 ms, which somebody who waits can see.
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

/// Renders an interactor's window once more when events have been looked at, by a timer.
class RenderLater
{
public:
  RenderLater();
  ~RenderLater();
  RenderLater(const RenderLater&) = delete;
  RenderLater& operator=(const RenderLater&) = delete;

  /// Asked again before that it does nothing more.
  void Ask(vtkRenderWindowInteractor* interactor);

private:
  static void Fired(vtkObject* caller, unsigned long event, void* self, void* timer);
  void Leave();

  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Observer = 0;
  int Timer = 0; ///< that is running; 0: none
  int Spent = 0; ///< the one before it
};
} // namespace pixelexact
