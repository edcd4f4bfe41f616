// SPDX-License-Identifier: BSD-3-Clause
// The triangles of polygonal data as a cut-surface, beside VTK's own mapper of the same data.
#include "CutScene.h"

#include "vtkHighOrderTriangleSurface.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkStripper.h"
#include "vtkTrivialProducer.h"

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;
using testing::Window;

/// A surface in BoxGrid's cube, cut in white in one window, and drawn in white in another.
class TriangleSurface : public ::testing::Test
{
protected:
  TriangleSurface()
  {
    Source->SetRadius(0.8);
    Source->SetCenter(0.1, 0.05, -0.05);
    Source->SetThetaResolution(9);
    Source->SetPhiResolution(6);
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Scene.Mapper->SetSurface(Surface);
    Scene.Mapper->ScalarVisibilityOff();
    Scene.Cut->GetProperty()->LightingOff();
    Ours.Renderer->AddActor(Scene.Cut);
    Stock->SetMapper(StockMapper);
    Stock->GetProperty()->LightingOff();
    Theirs.Renderer->AddActor(Stock);
    for (testing::Window* window : { &Ours, &Theirs })
    {
      CutScene::Look(window->Renderer, false);
      window->Renderer->GetActiveCamera()->SetClippingRange(1.0, 8.0);
    }
  }

  /// Pictures may differ where an outline passes a pixel's centre; elsewhere depths differ by
  /// rounding.
  void ExpectSamePictures()
  {
    Ours.Render();
    Theirs.Render();
    EXPECT_EQ(Errors->Text, "");
    int differing = 0;
    int shown = 0;
    for (int y = 0; y < Window::kHeight; ++y)
    {
      for (int x = 0; x < Window::kWidth; ++x)
      {
        const bool same = Ours.Color(x, y) == Theirs.Color(x, y) &&
          std::abs(Ours.Depth(x, y) - Theirs.Depth(x, y)) < 1e-6;
        differing += same ? 0 : 1;
        shown += Theirs.Color(x, y) != Window::kBackground ? 1 : 0;
      }
    }
    EXPECT_GT(shown, 5000);
    EXPECT_LT(differing, 10);
  }

  CutScene Scene;
  vtkNew<vtkHighOrderTriangleSurface> Surface;
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkActor> Stock;
  vtkNew<vtkPolyDataMapper> StockMapper;
  testing::Window Ours;
  testing::Window Theirs;
  vtkNew<ErrorObserver> Errors;
};
} // namespace

TEST_F(TriangleSurface, SilhouettesAndDepthsAreThoseOfVtksMapper)
{
  Surface->SetInputConnection(Source->GetOutputPort());
  StockMapper->SetInputConnection(Source->GetOutputPort());
  ExpectSamePictures();
  // As for any pipeline, the next picture shows its changes.
  const vtkIdType builds = Scene.Mapper->GetNumberOfSurfaceBuilds();
  Source->SetThetaResolution(4);
  ExpectSamePictures();
  EXPECT_EQ(Scene.Mapper->GetNumberOfSurfaceBuilds(), builds + 1);
  EXPECT_EQ(Surface->GetInput(), Source->GetOutput());
}

TEST_F(TriangleSurface, StripsAndPolygons)
{
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(Source->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  Surface->SetInputData(strips->GetOutput());
  StockMapper->SetInputData(strips->GetOutput());
  ExpectSamePictures();
  vtkNew<vtkRegularPolygonSource> polygon;
  polygon->SetNumberOfSides(7);
  polygon->GeneratePolylineOff();
  polygon->SetRadius(0.9);
  polygon->SetNormal(0.3, -0.4, 1.0);
  Surface->SetInputConnection(polygon->GetOutputPort());
  StockMapper->SetInputConnection(polygon->GetOutputPort());
  ExpectSamePictures();
}

TEST_F(TriangleSurface, AnotherMeshMakesNoTrianglesAnew)
{
  Surface->SetInputConnection(Source->GetOutputPort());
  Ours.Render();
  Scene.Grid->Modified();
  Ours.Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfModelBuilds(), 2);
  EXPECT_EQ(Scene.Mapper->GetNumberOfSurfaceBuilds(), 1);
}

TEST_F(TriangleSurface, WhatIsNoneIsRefused)
{
  const auto told = [this]
  {
    Errors->Text.clear();
    Ours.Render();
    EXPECT_EQ(Ours.Color(160, 120), Window::kBackground);
    return Errors->Text;
  };
  EXPECT_NE(told().find("vtkHighOrderTriangleSurface: it has no input"), std::string::npos)
    << Errors->Text;
  vtkNew<vtkPolyData> empty;
  Surface->SetInputData(empty);
  EXPECT_NE(told().find("no triangles"), std::string::npos) << Errors->Text;
  vtkNew<vtkImageData> image;
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  Surface->SetInputConnection(producer->GetOutputPort());
  EXPECT_NE(told().find("its input is a vtkImageData"), std::string::npos) << Errors->Text;
  Surface->SetInputConnection(Source->GetOutputPort());
  Surface->Update();
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(Source->GetOutput());
  broken->GetPoints()->SetPoint(3, nan, 0.0, 0.0);
  Surface->SetInputData(broken);
  EXPECT_NE(told().find("not finite"), std::string::npos) << Errors->Text;
}
} // namespace pixelexact
