// SPDX-License-Identifier: BSD-3-Clause
// Cut-surfaces that are no implicit functions: made once, drawn, picked and refused as functions
// are.
#include "CutScene.h"

#include "Core/Base/Error.h"
#include "Surfaces/VtkSurface.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderPicker.h"
#include "vtkHighOrderSurface.h"

#include "vtkObjectFactory.h"
#include "vtkPropPicker.h"

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;
using testing::Rgb;
using testing::Window;

/// The plane z = Height, which counts how often it is made.
class MadePlane : public vtkHighOrderSurface
{
public:
  static MadePlane* New();
  vtkTypeMacro(MadePlane, vtkHighOrderSurface);
  vtkSetMacro(Height, double);

  void Update() override { ++Updates; }
  std::shared_ptr<const Surface> MakeSurface(
    const std::shared_ptr<const HighOrderModel>& model, const SurfaceSearch& search) override
  {
    Model = model;
    EXPECT_NEAR(search.box.lower.x, -1.0, 1e-14);
    ++Builds;
    if (!(std::abs(Height) < 2.0))
    {
      throw Error("too high; lower it");
    }
    return std::make_shared<Plane>(Vec3(0.0, 0.0, Height), Vec3(0.0, 0.0, 1.0));
  }

  int Builds = 0;
  int Updates = 0;
  std::weak_ptr<const HighOrderModel> Model;

private:
  double Height = 0.0;
};
vtkStandardNewMacro(MadePlane);

/// CutScene with the same plane as a surface, in a window.
class HighOrderSurface : public ::testing::Test
{
protected:
  HighOrderSurface()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Window.Renderer->AddActor(Scene.Cut);
    Window.Renderer->AddActor(Scene.Sphere);
    CutScene::Look(Window.Renderer, false);
    Scene.Mapper->SetSurface(Plane);
  }

  void ExpectBuilds(int builds)
  {
    Window.Render();
    EXPECT_EQ(Scene.Mapper->GetNumberOfSurfaceBuilds(), builds);
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<MadePlane> Plane;
  vtkNew<ErrorObserver> Errors;
};
} // namespace

TEST_F(HighOrderSurface, IsDrawnBesideGeometryAsAFunctionIs)
{
  EXPECT_EQ(Scene.Mapper->GetNumberOfCutFunctions(), 0);
  Window.Render();
  CutScene::ExpectPicture(Window, { 0, 0, Window::kWidth, Window::kHeight });
  EXPECT_EQ(Errors->Text, "");
}

TEST_F(HighOrderSurface, IsMadeOnceForAllViewsCamerasAndColours)
{
  ExpectBuilds(1);
  Window.Renderer->GetActiveCamera()->Azimuth(20.0);
  ExpectBuilds(1);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 2);
  Scene.Mapper->SetScalarRange(0.0, 1.0);
  ExpectBuilds(1);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 2);
  Scene.Cut->GetProperty()->SetOpacity(0.5);
  ExpectBuilds(1);
  vtkNew<vtkRenderer> second;
  Window.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->AddActor(Scene.Cut);
  second->SetActiveCamera(Window.Renderer->GetActiveCamera());
  Window.RenderWindow->AddRenderer(second);
  ExpectBuilds(1);
  vtkNew<vtkHighOrderPicker> picker;
  EXPECT_EQ(picker->Pick(80.0, 120.0, 0.0, Window.Renderer), 1);
  ExpectBuilds(1);
  EXPECT_EQ(Plane->Builds, 1);
}

TEST_F(HighOrderSurface, IsMadeAnewWhereItOrTheDataChanged)
{
  ExpectBuilds(1);
  const vtkMTimeType before = Scene.Mapper->GetMTime();
  Plane->SetHeight(0.3);
  EXPECT_GT(Scene.Mapper->GetMTime(), before);
  ExpectBuilds(2);
  Scene.Grid->Modified();
  ExpectBuilds(3);
  const std::weak_ptr<const HighOrderModel> model = Plane->Model;
  EXPECT_FALSE(model.expired());
  const auto grid = testing::BoxGrid(1);
  Scene.Mapper->SetInputData(grid);
  ExpectBuilds(4);
  EXPECT_TRUE(model.expired()) << "somebody keeps the model of data that are gone";
}

TEST_F(HighOrderSurface, FunctionsAreMadeOnceToo)
{
  Scene.Mapper->SetCutFunction(Scene.Function);
  ExpectBuilds(1);
  Window.Renderer->GetActiveCamera()->Azimuth(20.0);
  ExpectBuilds(1);
  Scene.Function->SetOrigin(0.0, 0.0, 0.1);
  ExpectBuilds(2);
}

TEST_F(HighOrderSurface, LayersThatAreHiddenForAWhileKeepTheirs)
{
  Scene.Mapper->SetCutFunction(Scene.Function);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetSurface(Plane);
  Plane->SetHeight(0.5);
  layer->SetOpacity(0.5);
  Scene.Mapper->AddLayer(layer);
  ExpectBuilds(2);
  layer->VisibilityOff();
  ExpectBuilds(2);
  layer->VisibilityOn();
  ExpectBuilds(2);
  Scene.Mapper->RemoveLayer(layer);
  ExpectBuilds(2);
  Scene.Mapper->AddLayer(layer);
  ExpectBuilds(3);
}

TEST_F(HighOrderSurface, TheLastOfFunctionAndSurfaceCounts)
{
  EXPECT_EQ(Scene.Mapper->GetSurface(), Plane);
  Scene.Mapper->SetCutFunction(nullptr);
  EXPECT_EQ(Scene.Mapper->GetSurface(), Plane);
  Scene.Mapper->SetCutFunction(Scene.Function);
  EXPECT_EQ(Scene.Mapper->GetSurface(), nullptr);
  Scene.Mapper->SetSurface(nullptr);
  EXPECT_EQ(Scene.Mapper->GetNumberOfCutFunctions(), 1);
  Scene.Mapper->SetSurface(Plane);
  EXPECT_EQ(Scene.Mapper->GetNumberOfCutFunctions(), 0);
  // Both, where one is added; the function is the first layer.
  Plane->SetHeight(0.7);
  Scene.Mapper->AddCutFunction(Scene.Function);
  EXPECT_EQ(Scene.Mapper->GetSurface(), Plane);
  ExpectBuilds(2);
  vtkNew<vtkHighOrderPicker> picker;
  EXPECT_EQ(picker->Pick(160.0, 160.0, 0.0, Window.Renderer), 1);
  EXPECT_EQ(picker->GetLayer(), 1);
  EXPECT_NEAR(picker->GetMapperPosition()[2], 0.7, 1e-15);
  vtkNew<vtkHighOrderMapper> copy;
  copy->ShallowCopy(Scene.Mapper);
  EXPECT_EQ(copy->GetSurface(), Plane);

  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(Scene.Function);
  layer->SetSurface(nullptr);
  EXPECT_EQ(layer->GetCutFunction(), Scene.Function);
  layer->SetSurface(Plane);
  EXPECT_EQ(layer->GetCutFunction(), nullptr);
  const vtkMTimeType before = layer->GetMTime();
  Plane->SetHeight(0.1);
  EXPECT_GT(layer->GetMTime(), before);
  layer->SetCutFunction(Scene.Function);
  EXPECT_EQ(layer->GetSurface(), nullptr);
}

TEST_F(HighOrderSurface, IsSelected)
{
  Window.Render();
  vtkNew<vtkPropPicker> picker;
  EXPECT_EQ(picker->Pick(80.0, 120.0, 0.0, Window.Renderer), 1);
  EXPECT_EQ(picker->GetActor(), Scene.Cut);
  EXPECT_EQ(Plane->Builds, 1);
}

TEST_F(HighOrderSurface, WhatItThrowsIsToldAndNothingIsDrawn)
{
  Window.Render();
  const Rgb before = Window.Color(80, 120);
  EXPECT_NE(before, Window::kBackground);
  Plane->SetHeight(3.0);
  Window.Render();
  EXPECT_NE(Errors->Text.find("too high; lower it"), std::string::npos) << Errors->Text;
  EXPECT_EQ(Window.Color(80, 120), Window::kBackground);
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  Plane->SetHeight(0.0);
  Window.Render();
  EXPECT_EQ(Window.Color(80, 120), before);
  vtkNew<vtkHighOrderLayer> nothing;
  Scene.Mapper->AddLayer(nothing);
  Errors->Text.clear();
  Window.Render();
  EXPECT_NE(Errors->Text.find("no cut function and no surface"), std::string::npos) << Errors->Text;
}

TEST_F(HighOrderSurface, ItsPipelineIsBroughtUpToDateUnlessStatic)
{
  Window.Render();
  const int updates = Plane->Updates;
  EXPECT_GT(updates, 0);
  Scene.Mapper->StaticOn();
  Window.Render();
  EXPECT_EQ(Plane->Updates, updates);
}
} // namespace pixelexact
