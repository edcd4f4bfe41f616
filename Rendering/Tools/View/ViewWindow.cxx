// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewWindow.h"

#include "Base/Provenance.h"
#include "Base/Report.h"
#include "View/RunTool.h"
#include "View/ViewStyle.h"

#include "Core/Base/Error.h"
#include "Views/VtkCamera.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHighOrderMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

namespace pixelexact
{
namespace
{
/// Time of tracing between two events, which limits the time of a frame: while something is
/// dragged, and while the picture is completed.
constexpr double kSeconds = 0.03;
constexpr double kStillSeconds = 0.06;
/// Time after which the legend's axes follow a camera that moves.
constexpr std::chrono::milliseconds kLegendPeriod{ 150 };
/// A slider whose changes take longer changes the picture when it is released.
constexpr double kLiveSeconds = 0.2;
/// Smallest side of a figure in a window that is made smaller.
constexpr int kMinSide = 200;
} // namespace

ViewWindow::ViewWindow(const std::vector<std::string>& words)
  : Command(words, ViewLayout::LargestFigure())
  , Controls(Command)
  , Handles(MakeDragged(*Command.GetShot().scene.layers.front().surface,
      Command.Options().shot.surfaces.First(), BoxOf(*Command.GetShot().input.model)))
{
  const RenderOptions& options = Command.Options();
  const ImageSize& size = options.shot.size;
  PanelWidth = ViewPanel::WidthBeside(Command.GetShot().layout->font);
  Layout.Window().SetSize(size.width + PanelWidth, size.height);
  const Rgba background = options.shot.colors.BackgroundColor();
  Layout.Picture().SetBackground(
    background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  Layout.Picture().AddActor(&Scene.Actor());
  Layout.Picture().AddActor(&Scene.Outline());
  Layout.AddOver(Handles.Renderer());
  vtkNew<ViewStyle> style;
  style->Window = this;
  Interactor->SetRenderWindow(&Layout.Window());
  Interactor->SetInteractorStyle(style);
  Interactor->SetDesiredUpdateRate(1.0 / kSeconds);
  Scene.Mapper().SetProgressive(true);
  Scene.Mapper().SetStillSeconds(kStillSeconds);
  ApplyView(Command.GetShot().view, Layout.Picture().GetActiveCamera());
  ShowShot();
}

ViewWindow::~ViewWindow() = default;

void ViewWindow::Show()
{
  Observe(&Layout.Window(), vtkCommand::StartEvent, [this] { Update(); });
  Observe(Interactor, vtkCommand::TimerEvent, [this] { ReadPixel(); });
  Interactor->Initialize();
  Layout.Window().Render();
  Interactor->Start();
}

void ViewWindow::Update()
{
  const auto [width, height] = Layout.Size();
  const ImageSize& size = Command.Options().shot.size;
  if (width != size.width + PanelWidth || height != size.height)
  {
    Command.Resize(std::max(kMinSide, width - PanelWidth), std::max(kMinSide, height));
    LegendChanges = true;
    PanelChanges = true;
  }
  Shot& shot = Command.GetShot();
  vtkCamera* camera = Layout.Picture().GetActiveCamera();
  shot.view = ViewOf(camera);
  const bool isMoving = Layout.Window().GetDesiredUpdateRate() >= 1.0;
  if (!isMoving && Command.LayOut())
  {
    LegendChanges = true;
  }
  Layout.PlacePicture(shot.layout->corner, shot.size.width, shot.size.height);
  Layout.Picture().ResetCameraClippingRange();
  Handles.Update(*camera);
  const auto now = std::chrono::steady_clock::now();
  if (LegendChanges ||
    (!(shot.view == LegendView) && (!isMoving || now - LegendTime > kLegendPeriod)))
  {
    LegendTime = now;
    Layout.SetFigure(Scene.Figure(Command.Options(), shot));
    LegendView = shot.view;
    LegendChanges = false;
  }
  if (PanelChanges)
  {
    Layout.SetPanel(
      Controls.Panel().Draw(PanelWidth, size.height, Command.Options().font.Choice()), size.width);
    PanelChanges = false;
  }
}

ShownState ViewWindow::Now()
{
  ShownState& state = Command.State();
  state.now.view = ViewOf(Layout.Picture().GetActiveCamera());
  state.now.surface = Handles.Shape() != nullptr ? Handles.Shape()->Word() : std::string();
  return state;
}

void ViewWindow::Change(ShownState state)
{
  const auto begin = std::chrono::steady_clock::now();
  ShownState before = Now();
  bool isTaken = false;
  try
  {
    Command.Take(std::move(state));
    isTaken = true;
    ShowShot();
  }
  catch (const std::exception& error)
  {
    Tell(error.what());
    if (isTaken)
    {
      Command.Take(std::move(before));
      ShowShot();
    }
  }
  Controls.Show(Command);
  PanelChanges = true;
  ChangeSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void ViewWindow::ShowShot()
{
  Scene.Show(Command.Options(), Command.GetShot());
  // With several layers a saved figure finds the ranges of its own picture. Colours of a legend
  // have no range.
  const bool hasRange = Scene.Ranges().size() == 1 && !Command.Options().debug.IsInPlace();
  Command.State().now.range = hasRange ? Scene.Ranges().front() : std::nullopt;
  LegendChanges = true;
}

void ViewWindow::Tell(const std::string& text)
{
  Controls.Panel().text = text;
  PanelChanges = true;
}

void ViewWindow::ChooseField(std::size_t row)
{
  ShownState state = Now();
  Controls.ChooseField(row, state);
  Change(std::move(state));
}

void ViewWindow::GoToStep(int step)
{
  const auto steps = static_cast<int>(Command.GetShot().input.times.size());
  if (steps == 0)
  {
    Tell("the input has no time steps");
    return;
  }
  ShownState state = Now();
  state.now.step = std::clamp(step, 0, steps - 1);
  Change(std::move(state));
}

void ViewWindow::MoveSurface()
{
  try
  {
    const std::shared_ptr<const Surface> surface = Handles.Shape()->Now();
    Command.GetShot().scene.layers.front().surface = surface;
    Scene.MoveFirst(surface);
  }
  catch (const Error& error)
  {
    Tell(error.what());
  }
}

std::array<int, 2> ViewWindow::Pointer() const
{
  return { Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1] };
}

bool ViewWindow::IsInPicture() const
{
  return Layout.IsInPicture(Pointer());
}

std::array<double, 2> ViewWindow::OnPanel() const
{
  const auto [x, y] = Pointer();
  return { x + 0.5 - Command.Options().shot.size.width, y + 0.5 };
}

bool ViewWindow::Grab()
{
  if (IsInPicture() && !Handles.Grab(Pointer()))
  {
    return false;
  }
  const auto [x, y] = OnPanel();
  Slider = Controls.Panel().SliderAt(x, y);
  if (Slider || Handles.IsGrabbed())
  {
    // Pictures are coarse until the button is released.
    Layout.Window().SetDesiredUpdateRate(Interactor->GetDesiredUpdateRate());
  }
  if (Slider)
  {
    Slide(false);
  }
  else if (const auto row = Controls.Panel().FieldAt(x, y))
  {
    ChooseField(*row);
  }
  Layout.Window().Render();
  return true;
}

bool ViewWindow::Drag()
{
  if (Slider)
  {
    Slide(false);
  }
  else if (Handles.IsGrabbed())
  {
    Handles.DragTo(Pointer());
    MoveSurface();
  }
  else
  {
    return false;
  }
  Layout.Window().Render();
  return true;
}

bool ViewWindow::Release()
{
  if (!Slider && !Handles.IsGrabbed())
  {
    return false;
  }
  Layout.Window().SetDesiredUpdateRate(Interactor->GetStillUpdateRate());
  if (Slider)
  {
    Slide(true);
    Slider.reset();
  }
  Handles.Release();
  Layout.Window().Render();
  return true;
}

void ViewWindow::Slide(bool last)
{
  ViewPanel& panel = Controls.Panel();
  SliderValue& slider = panel.sliders[*Slider];
  const std::string option = slider.option;
  const double before = std::exchange(slider.value, panel.ValueAt(*Slider, OnPanel()[0]));
  PanelChanges = true;
  const bool isNew = slider.value != before;
  SlideWaits = SlideWaits || isNew;
  if (SlideWaits && (last || ChangeSeconds < kLiveSeconds))
  {
    SlideWaits = false;
    ShownState state = Now();
    Controls.Apply(*Slider, Command.GetShot(), state);
    Change(std::move(state));
  }
}

bool ViewWindow::Scroll(int fields)
{
  if (IsInPicture())
  {
    return false;
  }
  Controls.Panel().Scroll(fields);
  PanelChanges = true;
  Layout.Window().Render();
  return true;
}

void ViewWindow::Hover()
{
  Reader.Wait(*Interactor);
}

void ViewWindow::ReadPixel()
{
  auto* style = ViewStyle::SafeDownCast(Interactor->GetInteractorStyle());
  if (!Reader.IsDue() || style->GetState() != VTKIS_NONE || Slider || Handles.IsGrabbed())
  {
    return;
  }
  const auto [x, y] = Pointer();
  Handles.PointAt(Pointer());
  const std::string text = IsInPicture() ? Reader.Read(x, y, Layout.Picture()) : std::string();
  Tell(text.empty() ? "h: help" : text);
  Layout.Window().Render();
}

void ViewWindow::PrintCommand()
{
  Command.State() = Now();
  std::cout << RepeatedCommand{ Command.FigureWords(Command.NextName()), {} }.Text() << std::endl;
  Tell("the command is on the terminal");
}

void ViewWindow::Save()
{
  Command.State() = Now();
  const std::string name = Command.NextName();
  const RepeatedCommand command{ Command.FigureWords(name), {} };
  Tell("saving '" + name + "' ...");
  Layout.Window().Render();
  std::cout << command.Text() << std::endl;
  const bool saved = RunTool(command.given);
  Command.CountFigure();
  Tell((saved ? "saved '" : "could not be saved (see the terminal): '") + name + "'");
}

bool ViewWindow::Press(const std::string& key)
{
  ShownState state = Now();
  if (key == "h")
  {
    Layout.TurnHelp();
  }
  else if (key == "p" && Handles.Shape() != nullptr)
  {
    Handles.TurnVisible();
  }
  else if (key == "l" || key == "e")
  {
    bool& isShown = key == "l" ? state.now.contours : state.now.edges;
    isShown = !isShown;
    Change(std::move(state));
  }
  else if (key == "o")
  {
    state.Set("--mesh-outline",
      Command.Options().outline.IsAsked() ? std::nullopt : std::optional<std::string>("box"));
    Change(std::move(state));
  }
  else if (key == "r")
  {
    state.ForgetRange();
    Change(std::move(state));
  }
  else if (const auto row = Controls.RowAfter(key == "f" ? 1 : -1);
           row && (key == "f" || key == "F"))
  {
    ChooseField(*row);
  }
  else if (key == "Left" || key == "Right")
  {
    GoToStep(Command.GetShot().input.step + (key == "Left" ? -1 : 1));
  }
  else if (key == "s")
  {
    Save();
  }
  else if (key == "c")
  {
    PrintCommand();
  }
  else
  {
    return false;
  }
  Layout.Window().Render();
  return true;
}
} // namespace pixelexact
