// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewWindow.h"

#include "Command.h"
#include "DrawnShot.h"
#include "Report.h"
#include "View/GivenSurface.h"
#include "View/Spawn.h"

#include "Core/Base/Error.h"
#include "VtkCamera.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkHighOrderLayer.h>
#include <vtkHighOrderMapper.h>
#include <vtkHighOrderPicker.h>
#include <vtkImplicitPlaneRepresentation.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <utility>

namespace pixelexact
{
vtkStandardNewMacro(GivenSurfaceOfLayer);

namespace
{
/// Contours where the command line asks for none.
constexpr int kUsualContours = 10;
constexpr int kLetters = 15;

constexpr const char* kHelp = "drag        turn, shift: move, wheel: nearer\n"
                              "p           plane on, off: drag the cut, or the arrow\n"
                              "c           contours\n"
                              "e           edges of elements\n"
                              "r           colours over what is seen\n"
                              "left, right time step\n"
                              "s           save the exact figure\n"
                              "h           this help\n"
                              "q           close";

/// Turns and moves the camera as VTK's, whose keys are left out.
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

template <class Function>
void Observe(vtkObject* object, unsigned long event, Function function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Function(std::move(function)));
  command->SetClientDataDeleteCallback([](void* client) { delete static_cast<Function*>(client); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { (*static_cast<Function*>(client))(); });
  object->AddObserver(event, command);
}

void SetLetters(vtkTextActor& text, const std::string& words)
{
  text.SetInput(words.c_str());
  text.GetTextProperty()->SetFontSize(kLetters);
  text.GetTextProperty()->SetColor(0.0, 0.0, 0.0);
  text.GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  text.GetTextProperty()->SetBackgroundOpacity(0.75);
}

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
{
  if (Options.animation.IsAsked(Options.shot.input))
  {
    throw UsageError("view shows one picture; leave out --sweep, --turn and --time-step all");
  }
  Options.Check(NameOfFile(Options, 0));
  TheShot.emplace(Prepare(Options.shot, Watch));
  Contours = Options.contours.AreGiven();
  Edges = TheShot->edges.has_value();

  const Rgba background = Options.shot.colors.BackgroundColor();
  Renderer->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  Window->SetSize(TheShot->size.width, TheShot->size.height);
  Window->SetMultiSamples(0);
  Window->AddRenderer(Renderer);
  Window->SetWindowName("PixelExact");
  vtkNew<Style> style;
  style->Window = this;
  Interactor->SetRenderWindow(Window);
  Interactor->SetInteractorStyle(style);
  Mapper->SetProgressive(true);
  Actor->SetMapper(Mapper);
  Renderer->AddActor(Actor);
  MakeTables();
  MakeLayers();
  ShowContours();
  Actor->GetProperty()->SetEdgeVisibility(Edges);
  ApplyView(TheShot->view, Renderer->GetActiveCamera());
  Renderer->ResetCameraClippingRange(TheShot->input.grid->GetBounds());
}

ViewWindow::~ViewWindow() = default;

bool ViewWindow::HasPlane() const
{
  return dynamic_cast<const Plane*>(TheShot->scene.layers.front().surface.get()) != nullptr;
}

void ViewWindow::MakeTables()
{
  // Of what the view shows, as render's.
  Shot seen = *TheShot;
  const Frame frame = TraceShot(Options, seen, {});
  const Looks looks(Options.shot.colors, seen, frame);
  Ranges = looks.Ranges();
  Tables.clear();
  for (std::size_t k = 0; k < Ranges.size(); ++k)
  {
    Tables.push_back(Ranges[k]
        ? Options.shot.colors.TableOver(*Ranges[k], TheShot->settings[k].colormap)
        : nullptr);
  }
  Solids.clear();
  for (const ColorMap& map : looks.Maps())
  {
    const double any = 0.0;
    Rgba color{};
    map({ &any, 1 }, color.data());
    Solids.push_back({ color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 });
  }
}

void ViewWindow::MakeLayers()
{
  Mapper->SetInputData(TheShot->input.grid);
  Mapper->RemoveAllLayers();
  const std::vector<Layer>& layers = TheShot->scene.layers;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const LayerSettings& settings = TheShot->settings[k];
    vtkNew<vtkHighOrderLayer> layer;
    const bool moved = k == 0 && HasPlane();
    if (moved)
    {
      const auto& plane = dynamic_cast<const Plane&>(*layers[k].surface);
      const Vec3 normal = plane.Normal({});
      Cut->SetOrigin(plane.Point().x, plane.Point().y, plane.Point().z);
      Cut->SetNormal(normal.x, normal.y, normal.z);
      layer->SetCutFunction(Cut);
    }
    else
    {
      vtkNew<GivenSurfaceOfLayer> surface;
      surface->Set(layers[k].surface);
      layer->SetSurface(surface);
    }
    if (layers[k].field != nullptr)
    {
      layer->SetFieldName(layers[k].field->name.c_str());
      layer->SetComponent(layers[k].component);
    }
    layer->SetScalarVisibility(Tables[k] != nullptr);
    layer->SetLookupTable(Tables[k]);
    layer->SetColor(Solids[k].data());
    layer->SetOpacity(settings.opacity);
    const bool lit = settings.lights.value_or(TheShot->lights != Lit::Off);
    layer->SetLighting(lit);
    layer->SetLightFlat(lit && (settings.lights || TheShot->lights == Lit::On));
    Mapper->AddLayer(layer);
  }
  Mapper->SetUseLookupTableScalarRange(true);
}

void ViewWindow::ShowContours()
{
  const auto first =
    std::ranges::find_if(Ranges, [](const auto& range) { return range.has_value(); });
  Mapper->SetNumberOfContours(0);
  if (!Contours || first == Ranges.end())
  {
    return;
  }
  const ContourChoice choice = Options.contours.AreGiven()
    ? Options.contours.OfAll()
    : ContourChoice{ kUsualContours, false, {} };
  const std::vector<double> values =
    ContourValues(choice, **first, Options.shot.colors.Logarithm());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    Mapper->SetContourValue(static_cast<int>(i), values[i]);
  }
  Mapper->SetContourWidth(Options.contours.Style().width);
}

void ViewWindow::MakeWidgets()
{
  if (HasPlane())
  {
    PlaneShape->SetPlaceFactor(1.0);
    PlaneShape->PlaceWidget(TheShot->input.grid->GetBounds());
    // Its arrow stands in the middle of the mesh.
    std::array<double, 3> middle{};
    vtkBoundingBox(TheShot->input.grid->GetBounds()).GetCenter(middle.data());
    Cut->ProjectPoint(middle.data(), middle.data());
    PlaneShape->SetOrigin(middle.data());
    PlaneShape->SetNormal(Cut->GetNormal());
    PlaneShape->OutlineTranslationOff();
    PlaneShape->ScaleEnabledOff();
    PlaneShape->TubingOff();
    // It is drawn, since it is dragged, and not seen: the cut is there.
    PlaneShape->DrawPlaneOn();
    PlaneShape->GetPlaneProperty()->SetOpacity(0.01);
    PlaneShape->GetSelectedPlaneProperty()->SetOpacity(0.01);
    Observe(PlaneWidget, vtkCommand::StartInteractionEvent, [this] { Dragging = true; });
    Observe(PlaneWidget, vtkCommand::EndInteractionEvent,
      [this]
      {
        Dragging = false;
        TellWhatIsAt(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
      });
    PlaneWidget->SetInteractor(Interactor);
    PlaneWidget->SetRepresentation(PlaneShape);
    Observe(PlaneWidget, vtkCommand::InteractionEvent, [this] { MovePlane(); });
    PlaneWidget->On();
  }
  if (TheShot->input.times.size() > 1)
  {
    vtkNew<vtkSliderRepresentation2D> shape;
    shape->SetMinimumValue(0.0);
    shape->SetMaximumValue(static_cast<double>(TheShot->input.times.size() - 1));
    shape->SetValue(TheShot->input.step);
    shape->SetTitleText("time step");
    shape->SetLabelFormat("%.0f");
    shape->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    shape->GetPoint1Coordinate()->SetValue(0.35, 0.06);
    shape->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    shape->GetPoint2Coordinate()->SetValue(0.65, 0.06);
    for (vtkTextProperty* text : { shape->GetTitleProperty(), shape->GetLabelProperty() })
    {
      text->SetColor(0.0, 0.0, 0.0);
      text->ShadowOff();
    }
    shape->GetTubeProperty()->SetColor(0.6, 0.6, 0.6);
    shape->GetSliderProperty()->SetColor(0.2, 0.2, 0.2);
    shape->GetCapProperty()->SetColor(0.6, 0.6, 0.6);
    Slider->SetInteractor(Interactor);
    Slider->SetRepresentation(shape);
    Observe(Slider, vtkCommand::EndInteractionEvent,
      [this]
      {
        auto* slider = vtkSliderRepresentation::SafeDownCast(Slider->GetRepresentation());
        GoToStep(static_cast<int>(std::lround(slider->GetValue())));
      });
    Slider->On();
  }
}

void ViewWindow::MovePlane()
{
  PlaneShape->GetPlane(Cut);
  Window->Render();
}

void ViewWindow::GoToStep(int step)
{
  const auto steps = static_cast<int>(TheShot->input.times.size());
  if (steps == 0)
  {
    Status->SetInput("the input has no time steps");
    Window->Render();
    return;
  }
  step = std::clamp(step, 0, steps - 1);
  if (step != TheShot->input.step)
  {
    const ShownNow now = Now();
    const Shot before = std::move(*TheShot);
    TheShot.emplace(PrepareStep(Options.shot, step, before, Watch));
    if (now.plane)
    {
      TheShot->scene.layers.front().surface = std::make_shared<Plane>(*now.plane);
    }
    MakeLayers();
  }
  if (auto* slider = vtkSliderRepresentation::SafeDownCast(Slider->GetRepresentation()))
  {
    slider->SetValue(step);
  }
  Status->SetInput(fmt::format(
    "step {}, t = {}", step, Short(TheShot->input.times[static_cast<std::size_t>(step)]))
                     .c_str());
  Window->Render();
}

ShownNow ViewWindow::Now() const
{
  ShownNow now;
  if (HasPlane())
  {
    const double* o = Cut->GetOrigin();
    const double* n = Cut->GetNormal();
    now.plane.emplace(Vec3(o[0], o[1], o[2]), Vec3(n[0], n[1], n[2]));
  }
  now.view = ViewOf(Renderer->GetActiveCamera());
  if (Ranges.size() == 1)
  {
    now.range = Ranges.front();
  }
  if (!TheShot->input.times.empty())
  {
    now.step = TheShot->input.step;
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
  RepeatedCommand command{ WordsOf(now, Words, TheShot->chosen, std::to_string(kUsualContours)),
    {} };
  Status->SetInput(("saving '" + now.output + "' ...").c_str());
  Window->Render();
  std::cout << command.Text() << std::endl;
  const bool saved = RunTool(command.given);
  ++Saved;
  Status->SetInput(
    ((saved ? "saved '" : "could not be saved (see the terminal): '") + now.output + "'").c_str());
  Window->Render();
}

void ViewWindow::TellWhatIsAt(int x, int y)
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
  Status->SetInput(text.c_str());
  Window->Render();
}

void ViewWindow::TellHelp()
{
  HelpText->SetInput(Help ? kHelp : "h: help");
}

bool ViewWindow::Press(const std::string& key)
{
  if (key == "h")
  {
    Help = !Help;
    TellHelp();
  }
  else if (key == "p" && HasPlane())
  {
    PlaneWidget->SetEnabled(PlaneWidget->GetEnabled() == 0 ? 1 : 0);
  }
  else if (key == "c")
  {
    Contours = !Contours;
    ShowContours();
  }
  else if (key == "e")
  {
    Edges = !Edges;
    Actor->GetProperty()->SetEdgeVisibility(Edges);
  }
  else if (key == "r")
  {
    const ShownNow now = Now();
    if (now.plane)
    {
      TheShot->scene.layers.front().surface = std::make_shared<Plane>(*now.plane);
    }
    TheShot->view = now.view;
    MakeTables();
    MakeLayers();
    ShowContours();
    Bar->SetLookupTable(Tables.front());
  }
  else if (key == "Left" || key == "Right")
  {
    GoToStep(TheShot->input.step + (key == "Left" ? -1 : 1));
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
  SetLetters(*HelpText, "");
  SetLetters(*Status, "");
  HelpText->GetTextProperty()->SetFontFamilyToCourier();
  HelpText->GetTextProperty()->SetVerticalJustificationToTop();
  HelpText->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  HelpText->GetPositionCoordinate()->SetValue(0.01, 0.99);
  Status->SetDisplayPosition(10, 10);
  TellHelp();
  Renderer->AddViewProp(HelpText);
  Renderer->AddViewProp(Status);
  if (Tables.front() != nullptr)
  {
    Bar->SetLookupTable(Tables.front());
    Bar->SetTitle(TheShot->scene.layers.front().field->name.c_str());
    Bar->SetNumberOfLabels(5);
    Bar->UnconstrainedFontSizeOn();
    for (vtkTextProperty* text : { Bar->GetTitleTextProperty(), Bar->GetLabelTextProperty() })
    {
      text->SetColor(0.0, 0.0, 0.0);
      text->SetFontSize(kLetters);
      text->ShadowOff();
      text->ItalicOff();
      text->BoldOff();
    }
    Renderer->AddViewProp(Bar);
  }
  Interactor->Initialize();
  MakeWidgets();
  Observe(Interactor, vtkCommand::MouseMoveEvent,
    [this]
    {
      // While a button is down, the view or the plane moves.
      auto* style = vtkInteractorStyle::SafeDownCast(Interactor->GetInteractorStyle());
      if (style->GetState() == VTKIS_NONE && !Dragging)
      {
        TellWhatIsAt(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
      }
    });
  Window->Render();
  Interactor->Start();
}
} // namespace pixelexact
