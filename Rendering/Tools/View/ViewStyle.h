// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

namespace pixelexact
{
class ViewWindow;

/// Turns and moves the camera as VTK's style does, without its keys. Keys, and what a handle or the
/// panel grabs, are passed to the window.
class ViewStyle final : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewStyle* New();
  vtkTypeMacro(ViewStyle, vtkInteractorStyleTrackballCamera);

  void OnChar() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnMouseMove() override;

  ViewWindow* Window = nullptr; ///< must be set before the first event
};
} // namespace pixelexact
