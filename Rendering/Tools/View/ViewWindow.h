// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RenderOptions.h"
#include "Report.h"
#include "View/ShellWords.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkHighOrderMapper;
class vtkHighOrderPicker;
class vtkImplicitPlaneRepresentation;
class vtkImplicitPlaneWidget2;
class vtkLookupTable;
class vtkObject;
class vtkPlane;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkScalarBarActor;
class vtkSliderWidget;
class vtkTextActor;

namespace pixelexact
{
/// A window with a cut, by VTK: vtkHighOrderMapper draws it, vtkImplicitPlaneWidget2 moves the
/// first surface where that is a plane, vtkHighOrderPicker reads what is under the pointer. What
/// render's options say beyond that is drawn by the figure that `s` saves: it is made by render
/// itself, of words that are printed.
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
  /// A key was pressed; false: it has no meaning here.
  bool Press(const std::string& key);

private:
  void MakeLayers();
  void MakeTables();
  void ShowContours();
  void MakeWidgets();
  void GoToStep(int step);
  void Save();
  void TellWhatIsAt(int x, int y);
  void TellHelp();
  void MovePlane();
  [[nodiscard]] ShownNow Now() const;
  [[nodiscard]] bool HasPlane() const;

  RenderOptions Options;
  std::vector<std::string> Words;
  Stopwatch Watch;
  std::optional<Shot> TheShot;
  std::vector<vtkSmartPointer<vtkLookupTable>> Tables; ///< by layer; null: one colour
  std::vector<std::optional<std::array<double, 2>>> Ranges;
  std::vector<std::array<double, 3>> Solids;
  bool Contours = false;
  bool Edges = false;
  bool Help = false;
  bool Dragging = false; ///< the plane
  int Saved = 0;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkHighOrderMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkHighOrderPicker> Picker;
  vtkNew<vtkPlane> Cut;
  vtkNew<vtkImplicitPlaneRepresentation> PlaneShape;
  vtkNew<vtkImplicitPlaneWidget2> PlaneWidget;
  vtkNew<vtkSliderWidget> Slider;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> HelpText;
};
} // namespace pixelexact
