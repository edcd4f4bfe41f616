// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <string>

class vtkHighOrderPicker;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace pixelexact
{
/// Reads the pixel under a pointer that rests. While events are waiting, nothing is read, so that
/// reading delays no drag.
class PixelReader
{
public:
  PixelReader();
  ~PixelReader();
  PixelReader(const PixelReader&) = delete;
  PixelReader& operator=(const PixelReader&) = delete;

  /// The pointer moves: a TimerEvent of the interactor follows.
  void Wait(vtkRenderWindowInteractor& interactor);
  /// At a TimerEvent: whether it is time to read.
  [[nodiscard]] bool IsDue();
  /// Value, element, reference coordinates and position of a pixel of the window, in lines; empty
  /// where the picture has none.
  [[nodiscard]] std::string Read(int x, int y, vtkRenderer& renderer);

private:
  int Timer = 0; ///< 0: nothing is waiting
  int Spent = 0; ///< the timer before, to be destroyed
  vtkNew<vtkHighOrderPicker> Picker;
};
} // namespace pixelexact
