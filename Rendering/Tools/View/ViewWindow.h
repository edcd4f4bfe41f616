// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Report.h"
#include "Picture/RenderOptions.h"
#include "Picture/ShownWords.h"
#include "View/DraggedShape.h"
#include "View/ViewScene.h"
#include "View/ViewTexts.h"

#include <vtkNew.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkHighOrderPicker;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace pixelexact
{
/// A window with a cut, drawn by VTK. vtkHighOrderMapper draws it, a widget moves the first surface
/// if that is a DraggedShape, and vtkHighOrderPicker reads the pixel under the pointer. Effects of
/// render's other options are only in the figure that `s` saves: render makes it from a printed
/// command line.
class ViewWindow
{
public:
  /// `words`: of the command line, as PrepareWords gives them. Throws as Prepare.
  ViewWindow(RenderOptions options, std::vector<std::string> words);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /// Until it is closed.
  void Show();
  /// Handles a key. Returns false where it has no meaning here.
  bool Press(const std::string& key);

private:
  void MakeWidgets();
  void GoToStep(int step);
  void Save();
  void ReportPixel(int x, int y);
  /// Draws the shot, with contours and edges where they are on.
  void ShowShot();
  /// Takes the widget's place for the first surface.
  void MoveSurface();
  [[nodiscard]] ShownNow Now() const;

  RenderOptions Options;
  std::vector<std::string> Words;
  Stopwatch Watch;
  std::optional<Shot> shot_;
  ViewScene Shown;
  bool Contours = false;
  bool Edges = false;
  bool Dragging = false;                 ///< the surface
  std::unique_ptr<DraggedShape> Dragged; ///< null: the first surface stays where it is
  int Saved = 0;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkHighOrderPicker> Picker;
  StepSlider Slider;
  ViewTexts Texts;
};
} // namespace pixelexact
