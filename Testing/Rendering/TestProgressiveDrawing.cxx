// SPDX-License-Identifier: BSD-3-Clause
// What is shown while somebody drags the scene, and what is saved then.
#include "CutScene.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderWindowInteractor.h"

#include <chrono>
#include <thread>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::SameBytes;
using testing::Window;

/// A window's picture as users save it.
vtkSmartPointer<vtkImageData> Screenshot(Window& window, bool rerender = true)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window.RenderWindow);
  filter->SetShouldRerender(rerender);
  filter->ReadFrontBufferOff();
  filter->Update();
  return filter->GetOutput();
}

int Differing(vtkImageData* a, vtkImageData* b)
{
  const auto* one = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* other = static_cast<unsigned char*>(b->GetScalarPointer());
  int count = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    count += std::equal(one + 3 * i, one + 3 * i + 3, other + 3 * i) ? 0 : 1;
  }
  return count;
}

/// A window with a time limit, and one of the same view without.
class Dragging : public ::testing::Test
{
protected:
  Dragging()
  {
    Wanted.Renderer->AddActor(Exact.Cut);
    CutScene::Look(Wanted.Renderer, false);
    Shown.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Shown.Renderer, false);
    Interactor->SetRenderWindow(Shown.RenderWindow);
    Shown.Render();
    Wanted.Render();
    // Less than anything takes.
    Shown.RenderWindow->SetDesiredUpdateRate(1e9);
  }

  void Move()
  {
    Shown.Renderer->GetActiveCamera()->Azimuth(20.0);
    Wanted.Renderer->GetActiveCamera()->Azimuth(20.0);
    Wanted.Render();
  }
  /// The pixels that are not those of the exact frame.
  int Coarse() { return Differing(Screenshot(Shown, false), Screenshot(Wanted, false)); }
  vtkIdType Traces() { return Scene.Mapper->GetNumberOfTraces(); }

  CutScene Exact;
  CutScene Scene;
  Window Wanted;
  Window Shown;
  vtkNew<vtkRenderWindowInteractor> Interactor;
};
} // namespace

TEST_F(Dragging, CoarseFirstThenFinerUntilItIsExact)
{
  EXPECT_EQ(Coarse(), 0);
  EXPECT_TRUE(Scene.Mapper->IsFrameComplete());
  EXPECT_EQ(Scene.Mapper->GetNumberOfUnknownPixels(), 0);
  Move();
  Shown.Render();
  EXPECT_EQ(Traces(), 2);
  const int coarse = Coarse();
  EXPECT_GT(coarse, 0);
  EXPECT_FALSE(Scene.Mapper->IsFrameComplete());
  // Some tiles more each time, and a picture where they make one.
  int renders = 0;
  for (; !Scene.Mapper->IsFrameComplete(); ++renders)
  {
    Shown.Render();
    ASSERT_LE(Coarse(), coarse);
    ASSERT_LT(renders, 1000);
  }
  EXPECT_GT(renders, 2);
  const vtkIdType pictures = Traces();
  EXPECT_LE(pictures, 5); // one without what modules make
  EXPECT_EQ(Coarse(), 0);
  Shown.Render();
  EXPECT_EQ(Traces(), pictures);

  // Another view, coarse; then time enough.
  Move();
  Shown.Render();
  EXPECT_EQ(Traces(), pictures + 1);
  EXPECT_GT(Coarse(), 0);
  Shown.RenderWindow->SetDesiredUpdateRate(1e-4);
  Shown.Render();
  EXPECT_EQ(Traces(), pictures + 2);
  EXPECT_EQ(Coarse(), 0);
}

TEST_F(Dragging, StillFramesAreMadeInSlices)
{
  Shown.RenderWindow->SetDesiredUpdateRate(1e-4);
  Scene.Mapper->SetStillSeconds(1e-9);
  Interactor->Initialize();
  Move();
  Shown.Render();
  EXPECT_FALSE(Scene.Mapper->IsFrameComplete());
  EXPECT_GT(Coarse(), 0);
  // The interactor's timer does the rest.
  struct Loop
  {
    vtkHighOrderMapper* mapper;
    vtkRenderWindowInteractor* interactor;
  } loop{ Scene.Mapper, Interactor };
  vtkNew<vtkCallbackCommand> leave;
  leave->SetClientData(&loop);
  leave->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      const auto* const running = static_cast<const Loop*>(data);
      if (running->mapper->IsFrameComplete())
      {
        running->interactor->TerminateApp();
      }
    });
  const unsigned long leaving = Shown.RenderWindow->AddObserver(vtkCommand::EndEvent, leave);
  Interactor->Start();
  Shown.RenderWindow->RemoveObserver(leaving);
  EXPECT_TRUE(Scene.Mapper->IsFrameComplete());
  const vtkIdType traces = Traces();
  Shown.Render();
  EXPECT_EQ(Traces(), traces);
  EXPECT_EQ(Coarse(), 0);
  // Whoever saves the picture does not wait for it.
  Move();
  EXPECT_EQ(Differing(Screenshot(Shown), Screenshot(Wanted)), 0);
}

TEST_F(Dragging, ObserversEndAFrame)
{
  Shown.RenderWindow->SetDesiredUpdateRate(1e-4);
  Scene.Mapper->ProgressiveOff();
  int asked = 0;
  vtkNew<vtkCallbackCommand> end;
  end->SetClientData(&asked);
  end->SetCallback(
    [](vtkObject* window, unsigned long, void* count, void*)
    {
      ++*static_cast<int*>(count);
      static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
    });
  const unsigned long observer = Shown.RenderWindow->AddObserver(vtkCommand::AbortCheckEvent, end);
  // Makes tiles slow: each takes longer than the interval between two checks of the time.
  vtkNew<vtkCallbackCommand> slow;
  slow->SetCallback([](vtkObject*, unsigned long, void*, void*)
    { std::this_thread::sleep_for(std::chrono::milliseconds(15)); });
  const unsigned long slowly = Scene.Mapper->AddObserver(vtkCommand::ProgressEvent, slow);
  Move();
  Shown.Render();
  EXPECT_GT(asked, 0);
  EXPECT_FALSE(Scene.Mapper->IsFrameComplete());
  Shown.RenderWindow->RemoveObserver(observer);
  Scene.Mapper->RemoveObserver(slowly);
  Shown.Render();
  EXPECT_TRUE(Scene.Mapper->IsFrameComplete());
  EXPECT_EQ(Coarse(), 0);
}

TEST_F(Dragging, BuffersAreThoseOfTheCompleteFrame)
{
  Move();
  Shown.Render();
  EXPECT_GT(Coarse(), 0);
  vtkDataArray* value = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Value");
  const Frame frame = Scene.Traced(Shown.Renderer, Window::kWidth, Window::kHeight, Buffer::Value);
  EXPECT_TRUE(SameBytes(frame.centres.value, value));
}

TEST_F(Dragging, ScreenshotsAreExact)
{
  // Twice: the second one's camera may be where the first one's was.
  for (int i = 0; i < 2; ++i)
  {
    Move();
    Shown.Render();
    EXPECT_GT(Coarse(), 0);
    EXPECT_FALSE(Scene.Mapper->IsFrameComplete());
    EXPECT_EQ(Differing(Screenshot(Shown), Screenshot(Wanted)), 0);
    EXPECT_TRUE(Scene.Mapper->IsFrameComplete());
  }
}

TEST_F(Dragging, AWindowThatNobodyMovesIsExact)
{
  Shown.RenderWindow->SetInteractor(nullptr);
  Move();
  Shown.Render();
  EXPECT_EQ(Coarse(), 0);
}

TEST_F(Dragging, WhoDoesNotWantThisAlwaysGetsExactFrames)
{
  Scene.Mapper->ProgressiveOff();
  Move();
  Shown.Render();
  EXPECT_EQ(Coarse(), 0);
}
} // namespace pixelexact
