// SPDX-License-Identifier: BSD-3-Clause
// What a frame costs in VTK's window beyond its tracing: colours, depths, their way to the graphics
// card, and the draw. Needs a display (xvfb-run). Argument 0: the data set (BenchmarkData.h);
// argument 1: what changes from frame to frame.
#include "BenchmarkData.h"

#include "vtkHighOrderMapper.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace pixelexact::benchmarks
{
namespace
{
constexpr int kPixels = 1000;

enum Change
{
  Nothing, ///< draws the same pixels again
  Colours, ///< another range: colours, and draws
  View     ///< another camera: traces, colours, and draws
};

constexpr const char* kNames[] = { "draw alone", "colours and draw", "all" };

class Window
{
public:
  explicit Window(const PlaneCut& cut)
  {
    Convert->SetInputData(cut.source);
    Plane->SetOrigin(cut.origin.x, cut.origin.y, cut.origin.z);
    Plane->SetNormal(cut.normal.x, cut.normal.y, cut.normal.z);
    Mapper->SetInputConnection(Convert->GetOutputPort());
    Mapper->SetFieldName(cut.field->name.c_str());
    Mapper->SetCutFunction(Plane);
    Actor->SetMapper(Mapper);
    Renderer->AddActor(Actor);
    RenderWindow->SetOffScreenRendering(1);
    RenderWindow->SetMultiSamples(0);
    RenderWindow->SetSize(kPixels, kPixels);
    RenderWindow->AddRenderer(Renderer);
    const Vec3 eye = cut.origin + cut.normal;
    vtkCamera* camera = Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(cut.origin.x, cut.origin.y, cut.origin.z);
    camera->SetPosition(eye.x, eye.y, eye.z);
    Renderer->ResetCamera();
    Render();
  }

  void Advance(Change change)
  {
    Even = !Even;
    if (change == Colours)
    {
      Mapper->SetScalarRange(0.0, Even ? 1.0 : 0.5);
    }
    else if (change == View)
    {
      Renderer->GetActiveCamera()->Roll(Even ? 1.0 : -1.0);
    }
  }

  void Render()
  {
    RenderWindow->Render();
    RenderWindow->WaitForCompletion();
  }

private:
  vtkNew<vtkUnstructuredGridToHighOrderGrid> Convert;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkHighOrderMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> RenderWindow;
  bool Even = false;
};

void WindowFrame(benchmark::State& state)
{
  if (std::getenv("DISPLAY") == nullptr)
  {
    state.SkipWithError("no display: run under xvfb-run");
    return;
  }
  const PlaneCut& cut = GetPlaneCut(static_cast<int>(state.range(0)));
  const auto change = static_cast<Change>(state.range(1));
  Window window(cut);
  for (auto _ : state)
  {
    window.Advance(change);
    window.Render();
  }
  state.SetLabel(std::string(cut.name) + ", " + kNames[change]);
}

BENCHMARK(WindowFrame)
  ->ArgsProduct({ { 0, 1 }, { Nothing, Colours, View } })
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
} // namespace
} // namespace pixelexact::benchmarks
