// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
} // namespace pixelexact
