// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewWindow.h"

#include "Base/Command.h"
#include "Base/Provenance.h"
#include "Base/Report.h"
#include "View/RunTool.h"
#include "View/ViewTexts.h"

#include "Core/Base/Error.h"
#include "Views/VtkCamera.h"

#include <fmt/format.h>
#include <vtkAbstractWidget.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHighOrderMapper.h>
#include <vtkHighOrderPicker.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <utility>

namespace pixelexact
{
namespace
{
/// Time of tracing between two events, which limits the time of a frame.
constexpr double kSeconds = 0.03;

/// Turns and moves the camera as VTK's style does, without its keys.
class Style final : public vtkInteractorStyleTrackballCamera
{
public:
  static Style* New();
  vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera);

  void OnChar() override
  {
    const char* symbol = Interactor->GetKeySym();
    const std::string key = symbol != nullptr ? symbol : "";
    if (key == "q" || key == "Escape")
    {
      Interactor->ExitCallback();
    }
    else if (Window != nullptr)
    {
      Window->Press(key);
    }
  }
  ViewWindow* Window = nullptr;
};
vtkStandardNewMacro(Style);

std::string NameOfFile(const RenderOptions& options, int number)
{
  if (!options.output.empty())
  {
    const std::filesystem::path given(options.output);
    return number == 0
      ? options.output
      : (given.parent_path() /
          fmt::format("{}_{}{}", given.stem().string(), number, given.extension().string()))
          .string();
  }
  return fmt::format("{}_view_{}.png",
    std::filesystem::path(options.shot.input.files.front()).stem().string(), number);
}
} // namespace

ViewWindow::ViewWindow(RenderOptions options, std::vector<std::string> words)
  : Options(std::move(options))
  , Words(std::move(words))
  , Shown(Options)
{
  if (Options.animation.IsAsked(Options.shot.input))
  {
    throw UsageError("view shows one picture; leave out --sweep, --turn and --time-step all");
  }
  if (Options.quality.Stride() > 1)
  {
    throw UsageError("view draws coarse pictures while it is moved, and then all pixels; leave out "
                     "--stride");
  }
  Options.Check(NameOfFile(Options, 0));
  if (Options.debug.IsInPlace())
  {
    Note("--owners and --show are drawn in saved figures (key s), not in the window");
  }
  shot_.emplace(Prepare(Options.shot, Watch));
  Dragged = MakeDragged(*shot_->scene.layers.front().surface, Options.shot.surfaces.First());
  Contours = Options.contours.AreGiven();
  Edges = shot_->appearance.edges.has_value();

  const Rgba background = Options.shot.colors.BackgroundColor();
  Renderer->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  Window->SetSize(shot_->size.width, shot_->size.height);
  Window->SetMultiSamples(0);
  Window->AddRenderer(Renderer);
  Window->SetWindowName("PixelExact");
  vtkNew<Style> style;
  style->Window = this;
  Interactor->SetRenderWindow(Window);
  Interactor->SetInteractorStyle(style);
  Shown.Mapper().SetProgressive(true);
  Shown.Mapper().SetStillSeconds(kSeconds);
  Interactor->SetDesiredUpdateRate(1.0 / kSeconds);
  Renderer->AddActor(&Shown.Actor());
  Shown.FindRanges(*shot_);
  ShowShot();
  ApplyView(shot_->view, Renderer->GetActiveCamera());
  Renderer->ResetCameraClippingRange(shot_->input.grid->GetBounds());
}

ViewWindow::~ViewWindow() = default;

void ViewWindow::MakeWidgets()
{
  if (Dragged)
  {
    vtkAbstractWidget& widget = Dragged->Widget();
    widget.SetInteractor(Interactor);
    Dragged->Place(shot_->input.grid->GetBounds());
    Observe(&widget, vtkCommand::StartInteractionEvent, [this] { Dragging = true; });
    Observe(&widget, vtkCommand::EndInteractionEvent,
      [this]
      {
        Dragging = false;
        ReportPixel(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
      });
    Observe(&widget, vtkCommand::InteractionEvent, [this] { MoveSurface(); });
    widget.On();
  }
  if (const auto steps = static_cast<int>(shot_->input.times.size()); steps > 1)
  {
    Slider.AddTo(Interactor, steps, [this](int step) { GoToStep(step); });
    Slider.Set(shot_->input.step);
  }
}

void ViewWindow::ShowShot()
{
  Shown.Show(*shot_, Contours, Edges);
}

void ViewWindow::MoveSurface()
{
  try
  {
    shot_->scene.layers.front().surface = Dragged->Now();
  }
  catch (const Error& error)
  {
    Texts.Tell(error.what());
    return;
  }
  Shown.MoveFirst(shot_->scene.layers.front().surface);
  Window->Render();
}

void ViewWindow::GoToStep(int step)
{
  const auto steps = static_cast<int>(shot_->input.times.size());
  if (steps == 0)
  {
    Texts.Tell("the input has no time steps");
    Window->Render();
    return;
  }
  step = std::clamp(step, 0, steps - 1);
  if (step != shot_->input.step)
  {
    const Shot before = std::move(*shot_);
    shot_.emplace(PrepareStep(Options.shot, step, before, Watch));
    if (Dragged)
    {
      shot_->scene.layers.front().surface = before.scene.layers.front().surface;
    }
    ShowShot();
  }
  Slider.Set(step);
  Texts.Tell(fmt::format(
    "step {}, t = {}", step, Short(shot_->input.times[static_cast<std::size_t>(step)])));
  Window->Render();
}

ShownNow ViewWindow::Now() const
{
  ShownNow now;
  if (Dragged)
  {
    now.surface = Dragged->Word();
  }
  now.view = ViewOf(Renderer->GetActiveCamera());
  if (Shown.Ranges().size() == 1)
  {
    now.range = Shown.Ranges().front();
  }
  if (!shot_->input.times.empty())
  {
    now.step = shot_->input.step;
  }
  now.contours = Contours;
  now.edges = Edges;
  return now;
}

void ViewWindow::Save()
{
  ShownNow now = Now();
  now.output = NameOfFile(Options, Saved);
  while (Options.output.empty() && std::filesystem::exists(now.output))
  {
    now.output = NameOfFile(Options, ++Saved);
  }
  RepeatedCommand command{
    WordsOf(now, Words, shot_->chosen, std::to_string(ViewScene::kDefaultContours)), {}
  };
  Texts.Tell("saving '" + now.output + "' ...");
  Window->Render();
  std::cout << command.Text() << std::endl;
  const bool saved = RunTool(command.given);
  ++Saved;
  Texts.Tell((saved ? "saved '" : "could not be saved (see the terminal): '") + now.output + "'");
  Window->Render();
}

void ViewWindow::ReportPixel(int x, int y)
{
  std::string text;
  if (Picker->Pick(x, y, 0.0, Renderer) != 0 && Picker->GetVerdict() > 0)
  {
    const double* at = Picker->GetPickPosition();
    text = fmt::format("x = {}, {}, {}", Short(at[0]), Short(at[1]), Short(at[2]));
    if (Picker->GetVerdict() == 1)
    {
      const double* xi = Picker->GetXi();
      text =
        fmt::format("{} = {:.10g}, exact\nelement {}, xi = {}, {}, {}\n{}", Picker->GetFieldName(),
          Picker->GetValue(), Picker->GetElement(), Short(xi[0]), Short(xi[1]), Short(xi[2]), text);
    }
    else
    {
      text = "unknown: no element could be decided\n" + text;
    }
  }
  else
  {
    text = "nothing";
  }
  Texts.Tell(text);
  Window->Render();
}

bool ViewWindow::Press(const std::string& key)
{
  if (key == "h")
  {
    Texts.TurnHelp();
  }
  else if (key == "p" && Dragged)
  {
    vtkAbstractWidget& widget = Dragged->Widget();
    widget.SetEnabled(widget.GetEnabled() == 0 ? 1 : 0);
  }
  else if (key == "c")
  {
    Contours = !Contours;
    ShowShot();
  }
  else if (key == "e")
  {
    Edges = !Edges;
    ShowShot();
  }
  else if (key == "r")
  {
    shot_->view = Now().view;
    Shown.FindRanges(*shot_);
    ShowShot();
    Texts.SetTable(Shown.FirstTable(*shot_));
  }
  else if (key == "Left" || key == "Right")
  {
    GoToStep(shot_->input.step + (key == "Left" ? -1 : 1));
  }
  else if (key == "s")
  {
    Save();
  }
  else
  {
    return false;
  }
  Window->Render();
  return true;
}

void ViewWindow::Show()
{
  const Layer& first = shot_->scene.layers.front();
  Texts.AddTo(*Renderer, Shown.FirstTable(*shot_), first.field != nullptr ? first.field->name : "");
  Interactor->Initialize();
  MakeWidgets();
  Observe(Interactor, vtkCommand::MouseMoveEvent,
    [this]
    {
      // While a button is down, it moves the view or the plane.
      auto* style = vtkInteractorStyle::SafeDownCast(Interactor->GetInteractorStyle());
      if (style->GetState() == VTKIS_NONE && !Dragging)
      {
        ReportPixel(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
      }
    });
  Window->Render();
  Interactor->Start();
}
} // namespace pixelexact
