// SPDX-License-Identifier: BSD-3-Clause
// One mapper in several views: eyes, viewports, cameras that transform.
#include "CutScene.h"

#include "vtkCutter.h"
#include "vtkImageData.h"
#include "vtkTransform.h"

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Rgb;
using testing::Window;

/// The same plane through the same box by VTK's own filter, in the colour of a flat property.
vtkSmartPointer<vtkActor> StockCut(CutScene& scene)
{
  vtkNew<vtkImageData> box;
  box->SetDimensions(3, 3, 3);
  box->SetOrigin(-1.0, -1.0, -1.0);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(box);
  cutter->SetCutFunction(scene.Function);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cutter->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// A window with the sphere and a cut, ours or VTK's, in plain yellow.
struct PlainWindow : Window
{
  explicit PlainWindow(bool ours)
  {
    Scene.Mapper->ScalarVisibilityOff();
    const vtkSmartPointer<vtkActor> cut = ours ? Scene.Cut.Get() : StockCut(Scene).Get();
    cut->GetProperty()->SetColor(1.0, 1.0, 0.0);
    cut->GetProperty()->LightingOff();
    Renderer->AddActor(cut);
    Renderer->AddActor(Scene.Sphere);
    CutScene::Look(Renderer, false);
    Renderer->GetActiveCamera()->SetClippingRange(1.0, 8.0);
    Renderer->GetActiveCamera()->SetEyeAngle(8.0);
  }

  CutScene Scene;
};

/// Both show the same, but for pixels that an edge goes through.
void ExpectSamePicture(Window& ours, Window& stock, double depths = 3e-7)
{
  int differing = 0;
  int shown = 0;
  for (int y = 0; y < Window::kHeight; ++y)
  {
    for (int x = 0; x < Window::kWidth; ++x)
    {
      const Rgb color = ours.Color(x, y);
      const bool same = color == stock.Color(x, y);
      differing += same ? 0 : 1;
      shown += color != Window::kBackground ? 1 : 0;
      if (same && depths > 0.0)
      {
        ASSERT_NEAR(ours.Depth(x, y), stock.Depth(x, y), depths) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(shown, 10000);
  // Pixels differ where an outline meets a centre.
  EXPECT_LT(differing, 40);
}

void SetStereo(Window& window, int type)
{
  window.RenderWindow->SetStereoCapableWindow(1);
  window.RenderWindow->SetStereoType(type);
  window.RenderWindow->SetStereoRender(1);
}
} // namespace

TEST(Views, EachEyeSeesTheCutWhereItSeesGeometry)
{
  PlainWindow mono(true);
  mono.Render();
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    for (const bool parallel : { false, true })
    {
      PlainWindow ours(true);
      PlainWindow stock(false);
      for (PlainWindow* window : { &ours, &stock })
      {
        SetStereo(*window, type);
        window->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
        window->Render();
      }
      ExpectSamePicture(ours, stock);
      int moved = 0;
      for (int x = 0; x < Window::kWidth; ++x)
      {
        moved += ours.Color(x, Window::kHeight / 2) != mono.Color(x, Window::kHeight / 2) ? 1 : 0;
      }
      EXPECT_GT(moved, 3);
    }
  }
}

TEST(Views, BothEyesInOneWindow)
{
  for (const int type :
    { VTK_STEREO_RED_BLUE, VTK_STEREO_INTERLACED, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    PlainWindow ours(true);
    PlainWindow stock(false);
    for (PlainWindow* window : { &ours, &stock })
    {
      SetStereo(*window, type);
      window->Render();
    }
    // The depths are those of one eye.
    ExpectSamePicture(ours, stock, 0.0);
    EXPECT_EQ(ours.Scene.Mapper->GetNumberOfTraces(), 2);
    ours.Render();
    EXPECT_EQ(ours.Scene.Mapper->GetNumberOfTraces(), 2);
  }
}

TEST(Views, CamerasWithAModelTransform)
{
  PlainWindow ours(true);
  PlainWindow stock(false);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.2, 0.0);
  transform->RotateZ(30.0);
  transform->Scale(1.2, 0.9, 1.0);
  for (PlainWindow* window : { &ours, &stock })
  {
    window->Renderer->GetActiveCamera()->SetModelTransformMatrix(transform->GetMatrix());
    window->Render();
  }
  ExpectSamePicture(ours, stock);
}

TEST(Views, FourViewportsHaveAFrameEach)
{
  CutScene scene;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(Window::kWidth, Window::kHeight);
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  for (int i = 0; i < 4; ++i)
  {
    renderers.push_back(vtkSmartPointer<vtkRenderer>::New());
    const double x = 0.5 * (i % 2);
    const double y = 0.5 * (i / 2);
    renderers.back()->SetViewport(x, y, x + 0.5, y + 0.5);
    renderers.back()->AddActor(scene.Cut);
    CutScene::Look(renderers.back(), i == 3);
    renderers.back()->GetActiveCamera()->Azimuth(15.0 * i);
    window->AddRenderer(renderers.back());
  }
  const auto traces = [&]
  {
    window->Render();
    return scene.Mapper->GetNumberOfTraces();
  };
  EXPECT_EQ(traces(), 4);
  EXPECT_EQ(traces(), 4);
  renderers[2]->GetActiveCamera()->Azimuth(1.0);
  EXPECT_EQ(traces(), 5);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  EXPECT_EQ(traces(), 5);
  EXPECT_EQ(scene.Mapper->GetNumberOfColorings(), 9);
  // A renderer that went takes its frame along; the others keep theirs.
  window->RemoveRenderer(renderers[0]);
  renderers.erase(renderers.begin());
  EXPECT_EQ(traces(), 5);
}

TEST(Views, OneMapperForTwoActors)
{
  CutScene scene;
  Window window;
  vtkNew<vtkActor> other;
  other->SetMapper(scene.Mapper);
  other->SetPosition(0.0, 0.0, -0.7);
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(other);
  CutScene::Look(window.Renderer, false);
  window.Render();
  window.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 2);
}
} // namespace pixelexact
