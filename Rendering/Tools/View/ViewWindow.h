// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "View/PixelReader.h"
#include "View/ShapeHandles.h"
#include "View/ShownCommand.h"
#include "View/ViewControls.h"
#include "View/ViewLayout.h"
#include "View/ViewScene.h"

#include <vtkNew.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;

namespace pixelexact
{
/// A window with a figure, drawn by VTK, and a panel. vtkHighOrderMapper draws the picture, handles
/// move the first surface if that is a DraggedShape, and vtkHighOrderPicker reads the pixel under
/// the pointer. Every change is one of a command line of render, from which `s` saves the figure.
class ViewWindow
{
public:
  /// `words`: of the command line, as PrepareWords gives them. Throws as Prepare.
  explicit ViewWindow(const std::vector<std::string>& words);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// Until it is closed.
  void Show();

  /// Handles a key. Returns false where it has no meaning here.
  bool Press(const std::string& key);
  /// The left button goes down; returns whether a handle or the panel takes it.
  bool Grab();
  /// The pointer moves; returns whether what was grabbed follows it.
  bool Drag();
  bool Release();
  /// Returns whether the pointer is on the panel, whose list of fields it then moves.
  bool Scroll(int fields);
  [[nodiscard]] bool IsInPicture() const;
  /// Reads the pixel under the pointer, once no further events are waiting.
  void Hover();

private:
  /// Takes another state, or reports why there is none.
  void Change(ShownState state);
  void ShowShot();
  void ChooseField(std::size_t row);
  void GoToStep(int step);
  /// Sets the grabbed slider's value at the pointer; `last`: no further values follow.
  void Slide(bool last);
  void MoveSurface();
  void PrintCommand();
  void Save();
  void ReadPixel();
  void Tell(const std::string& text);
  /// Before a frame: brings size, legend, panel and handles up to date.
  void Update();
  [[nodiscard]] std::array<int, 2> Pointer() const;
  [[nodiscard]] std::array<double, 2> OnPanel() const;
  /// The command's state with the camera and the surface that are shown.
  ShownState Now();

  ViewLayout Layout;
  ShownCommand Command;
  ViewControls Controls;
  ShapeHandles Handles;
  ViewScene Scene;

  std::optional<std::size_t> Slider; ///< the grabbed one
  bool SlideWaits = false;           ///< its value is not applied yet
  double ChangeSeconds = 0.0;        ///< of the last change
  int PanelWidth = 0;
  bool PanelChanges = true;
  bool LegendChanges = true;
  CameraView LegendView; ///< of the drawn legend
  std::chrono::steady_clock::time_point LegendTime;

  vtkNew<vtkRenderWindowInteractor> Interactor;
  PixelReader Reader;
};
} // namespace pixelexact
