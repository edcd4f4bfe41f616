// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkImplicitBoolean.h"
#include "vtkPointData.h"

#include <cstring>
#include <limits>

namespace pixelexact
{
namespace
{
using testing::Contains;
using testing::CutScene;
using testing::Window;

/// Renders and returns what the mapper complained about.
class HighOrderMapperErrors : public ::testing::Test
{
protected:
  HighOrderMapperErrors()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Window.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Window.Renderer, false);
  }

  std::string Render()
  {
    Errors->Text.clear();
    Window.RenderWindow->Render();
    return Errors->Text;
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<testing::ErrorObserver> Errors;
};

} // namespace

TEST_F(HighOrderMapperErrors, NoneInASoundScene)
{
  EXPECT_EQ(Render(), "");
  EXPECT_NE(Scene.Mapper->GetBuffers(), nullptr);
}

TEST_F(HighOrderMapperErrors, GridWithoutArrays)
{
  vtkNew<vtkUnstructuredGrid> plain;
  plain->CopyStructure(Scene.Grid);
  Scene.Mapper->SetInputData(plain);
  EXPECT_TRUE(Contains(Render(), "vtkUnstructuredGridToHighOrderGrid")) << Errors->Text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  // The camera can be placed nevertheless.
  EXPECT_EQ(Scene.Mapper->GetBounds()[0], -1.0);
}

TEST_F(HighOrderMapperErrors, UnknownField)
{
  EXPECT_EQ(Render(), "");
  Scene.Mapper->SetFieldName("pressure");
  const std::string text = Render();
  EXPECT_TRUE(Contains(text, "'pressure'") && Contains(text, "'u', 'v', 'nan'")) << text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  Scene.Mapper->SetFieldName("u");
  EXPECT_EQ(Render(), "");
  EXPECT_NE(Scene.Mapper->GetBuffers(), nullptr);
  Scene.Mapper->SetFieldName(nullptr);
  Scene.Mapper->SelectColorArray(3);
  EXPECT_TRUE(Contains(Render(), "number 3")) << Errors->Text;
}

TEST_F(HighOrderMapperErrors, AreToldOnce)
{
  Scene.Mapper->SetFieldName("pressure");
  EXPECT_NE(Render(), "");
  EXPECT_EQ(Render(), "");
  // The error is also reported in another view.
  vtkNew<vtkRenderer> second;
  Window.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->AddActor(Scene.Cut);
  second->SetActiveCamera(Window.Renderer->GetActiveCamera());
  Window.RenderWindow->AddRenderer(second);
  EXPECT_EQ(Render(), "");
  Scene.Mapper->SetFieldName("density");
  EXPECT_TRUE(Contains(Render(), "'density'")) << Errors->Text;
  // After a correct frame, the error is reported again.
  Scene.Mapper->SetFieldName("u");
  EXPECT_EQ(Render(), "");
  Scene.Mapper->SetFieldName("density");
  EXPECT_NE(Render(), "");
}

TEST_F(HighOrderMapperErrors, ImpossibleCuts)
{
  Scene.Mapper->RemoveAllCutFunctions();
  EXPECT_TRUE(Contains(Render(), "SetCutFunction")) << Errors->Text;
  vtkNew<vtkImplicitBoolean> nothing;
  Scene.Mapper->SetCutFunction(nothing);
  EXPECT_TRUE(Contains(Render(), "vtkImplicitBoolean")) << Errors->Text;
  Scene.Mapper->SetCutFunction(Scene.Function);
  Scene.Function->SetNormal(0.0, 0.0, 0.0);
  EXPECT_TRUE(Contains(Render(), "normal")) << Errors->Text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
}

TEST_F(HighOrderMapperErrors, ComponentOutOfRange)
{
  Scene.Mapper->SetFieldName("v");
  Scene.Table->SetVectorComponent(3);
  EXPECT_TRUE(Contains(Render(), "component 3")) << Errors->Text;
}

TEST_F(HighOrderMapperErrors, CameraThatIsNone)
{
  Window.Renderer->GetActiveCamera()->SetPosition(
    std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0);
  EXPECT_NE(Render(), "");
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  CutScene::Look(Window.Renderer, false);
  EXPECT_EQ(Render(), "");
}

TEST_F(HighOrderMapperErrors, FlatActor)
{
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(2, 2, 0.0);
  Scene.Cut->SetUserMatrix(flat);
  EXPECT_NE(Render(), "");
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
}

TEST_F(HighOrderMapperErrors, AbortedFramesAreTracedAnew)
{
  struct Watch
  {
    vtkHighOrderMapper* mapper;
    bool abort;
    int calls;
    double last;
  } watch{ Scene.Mapper, true, 0, 0.0 };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* data)
    {
      auto* w = static_cast<Watch*>(client);
      ++w->calls;
      w->last = *static_cast<double*>(data);
      w->mapper->SetAbortExecute(w->abort);
    });
  Scene.Mapper->AddObserver(vtkCommand::ProgressEvent, command);
  EXPECT_EQ(Render(), "");
  EXPECT_GT(watch.calls, 0);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 1);
  watch.abort = false;
  EXPECT_EQ(Render(), "");
  EXPECT_EQ(watch.last, 1.0);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 2);
  EXPECT_EQ(Render(), "");
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 2);
  const Frame frame =
    Scene.Traced(Window.Renderer, testing::Window::kWidth, testing::Window::kHeight, Buffer::Value);
  vtkDataArray* value = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Value");
  EXPECT_EQ(std::memcmp(frame.centres.value.data(), value->GetVoidPointer(0),
              frame.centres.value.size() * sizeof(double)),
    0);
}
} // namespace pixelexact
