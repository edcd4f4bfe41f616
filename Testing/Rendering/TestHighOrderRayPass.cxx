// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "vtkHighOrderRayPass.h"

#include "vtkCameraPass.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkPointData.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <cstring>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Window;

vtkSmartPointer<vtkRenderPass> Chain(vtkRenderPass* ours)
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(ours);
  passes->AddItem(vtkNew<vtkTranslucentPass>());
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

void ResetRange(Window& window, vtkHighOrderRayPass* pass)
{
  double bounds[6];
  pass->GetBounds(bounds);
  window.Renderer->ResetCameraClippingRange(bounds);
}
} // namespace

TEST(HighOrderRayPass, DrawsWhatTheMapperDraws)
{
  for (const bool parallel : { false, true })
  {
    CutScene scene;
    Window asProp;
    asProp.Renderer->AddActor(scene.Cut);
    asProp.Renderer->AddActor(scene.Sphere);
    CutScene::Look(asProp.Renderer, parallel);
    asProp.Render();
    vtkNew<vtkImageData> buffers;
    buffers->DeepCopy(scene.Mapper->GetBuffers());

    CutScene other;
    Window asPass;
    vtkNew<vtkHighOrderRayPass> pass;
    pass->AddActor(other.Cut);
    asPass.Renderer->SetPass(Chain(pass));
    asPass.Renderer->AddActor(other.Sphere);
    CutScene::Look(asPass.Renderer, parallel);
    ResetRange(asPass, pass);
    asPass.Render();
    EXPECT_EQ(pass->GetNumberOfRenderedProps(), 1);
    CutScene::ExpectPicture(asPass, Window::kWhole);

    // Two windows, two models, two ways: one set of bits.
    for (const char* name : { "Value", "Position", "Xi", "Depth" })
    {
      vtkDataArray* a = buffers->GetPointData()->GetArray(name);
      vtkDataArray* b = other.Mapper->GetBuffers()->GetPointData()->GetArray(name);
      ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
      EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                  static_cast<std::size_t>(a->GetNumberOfValues()) * sizeof(double)),
        0)
        << name;
    }
  }
}

TEST(HighOrderRayPass, BesideTheOpaquePassOfTheDefaultSteps)
{
  CutScene scene;
  Window window;
  vtkNew<vtkHighOrderRayPass> pass;
  pass->AddActor(scene.Cut);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(pass); // before the opaque geometry, for once
  passes->AddItem(vtkNew<vtkOpaquePass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetOpaquePass(sequence);
  window.Renderer->SetPass(steps);
  window.Renderer->AddActor(scene.Sphere);
  CutScene::Look(window.Renderer, false);
  ResetRange(window, pass);
  window.Render();
  CutScene::ExpectPicture(window, Window::kWhole);
}

TEST(HighOrderRayPass, UnderSuperSampling)
{
  CutScene scene;
  Window window;
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(scene.Sphere);
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  window.Renderer->SetPass(ssaa);
  CutScene::Look(window.Renderer, false);
  window.Render();
  // The framebuffer within is larger than the window, and the colours are means.
  int size[3];
  scene.Mapper->GetBuffers()->GetDimensions(size);
  EXPECT_GT(size[0], Window::kWidth);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  const testing::VtkRays rays(camera, Window::kWidth, Window::kHeight);
  int checked = 0;
  for (int j = 2; j < Window::kHeight - 2; ++j)
  {
    for (int i = 2; i < Window::kWidth - 2; ++i)
    {
      bool uniform = true;
      const auto meet = [&](double x, double y) { return CutScene::Meet(rays.At(x, y)); };
      const auto expected = meet(i + 0.5, j + 0.5);
      for (const double d : { -2.0, 2.0 })
      {
        uniform = uniform && meet(i + 0.5 + d, j + 0.5).seen == expected.seen &&
          meet(i + 0.5, j + 0.5 + d).seen == expected.seen;
      }
      if (uniform && expected.seen == CutScene::Seen::Cut)
      {
        ++checked;
        ASSERT_NEAR(window.Color(i, j)[0], CutScene::Gray(expected.position), 2);
      }
    }
  }
  EXPECT_GT(checked, 5000);
}

TEST(HighOrderRayPass, ListOfActors)
{
  CutScene scene;
  vtkNew<vtkHighOrderRayPass> pass;
  double bounds[6];
  pass->GetBounds(bounds);
  EXPECT_GT(bounds[0], bounds[1]);
  pass->AddActor(scene.Cut);
  pass->AddActor(nullptr);
  EXPECT_EQ(pass->GetNumberOfActors(), 1);
  EXPECT_EQ(pass->GetActor(0), scene.Cut);
  EXPECT_EQ(pass->GetActor(1), nullptr);
  pass->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 1.0, 1e-12);
  const vtkMTimeType time = pass->GetMTime();
  scene.Function->SetOrigin(0.0, 0.0, 0.1);
  EXPECT_GT(pass->GetMTime(), time);

  Window window;
  window.Renderer->SetPass(Chain(pass));
  CutScene::Look(window.Renderer, false);
  ResetRange(window, pass);
  scene.Cut->VisibilityOff();
  window.RenderWindow->Render();
  EXPECT_EQ(pass->GetNumberOfRenderedProps(), 0);
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 0);

  vtkNew<testing::ErrorObserver> errors;
  pass->AddObserver(vtkCommand::ErrorEvent, errors);
  pass->AddActor(scene.Sphere);
  window.RenderWindow->Render();
  EXPECT_NE(errors->Text.find("vtkHighOrderMapper"), std::string::npos);
  pass->RemoveActor(scene.Sphere);
  EXPECT_EQ(pass->GetNumberOfActors(), 1);
  pass->RemoveAllActors();
  EXPECT_EQ(pass->GetNumberOfActors(), 0);
}
} // namespace pixelexact
