// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "vtkHighOrderPicker.h"

#include "vtkAssembly.h"
#include "vtkDoubleArray.h"
#include "vtkHighOrderLayer.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;
using testing::Window;

/// The cut in a window, and what its pixels show.
struct Picked
{
  explicit Picked(bool parallel = false)
  {
    Window.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Window.Renderer, parallel);
  }

  bool Pick(int i, int j) { return Picker->Pick(i, j, 0.0, Window.Renderer) != 0; }

  /// Compares picks of pixels with those pixels; returns how many show the cut.
  int ExpectPixels()
  {
    Window.RenderWindow->Render();
    vtkPointData* buffers = Scene.Mapper->GetBuffers()->GetPointData();
    const auto component = [&](const char* name, vtkIdType pixel, int c)
    { return buffers->GetArray(name)->GetComponent(pixel, c); };
    int cuts = 0;
    for (int j = 3; j < Window::kHeight; j += 19)
    {
      for (int i = 3; i < Window::kWidth; i += 17)
      {
        const vtkIdType pixel = static_cast<vtkIdType>(j) * Window::kWidth + i;
        const bool seen = component("Color", pixel, 3) > 0.0;
        EXPECT_EQ(Pick(i, j), seen) << i << ", " << j;
        if (!seen || Picker->GetVerdict() == 0)
        {
          continue;
        }
        ++cuts;
        EXPECT_EQ(Picker->GetVerdict(), component("Verdict", pixel, 0));
        EXPECT_EQ(Picker->GetElement(), component("Element", pixel, 0));
        EXPECT_EQ(Picker->GetLayer(), component("Layer", pixel, 0));
        EXPECT_EQ(Picker->GetValue(), component("Value", pixel, 0)); // bit for bit
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_EQ(Picker->GetMapperPosition()[c], component("Position", pixel, c));
          EXPECT_EQ(Picker->GetMapperNormal()[c], component("Normal", pixel, c));
          EXPECT_EQ(Picker->GetXi()[c], component("Xi", pixel, c));
        }
      }
    }
    return cuts;
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<vtkHighOrderPicker> Picker;
};

void ExpectNothing(vtkHighOrderPicker* picker)
{
  EXPECT_EQ(picker->GetActor(), nullptr);
  EXPECT_EQ(picker->GetMapper(), nullptr);
  EXPECT_EQ(picker->GetVerdict(), 0);
  EXPECT_EQ(picker->GetElement(), -1);
  EXPECT_EQ(picker->GetCellId(), -1);
  EXPECT_EQ(picker->GetLayer(), -1);
  EXPECT_TRUE(std::isnan(picker->GetValue()) && std::isnan(picker->GetXi()[0]));
  EXPECT_EQ(picker->GetFieldValues()->GetNumberOfTuples(), 0);
}
} // namespace

TEST(HighOrderPicker, PicksWhatThePixelShows)
{
  for (const bool parallel : { false, true })
  {
    Picked picked(parallel);
    EXPECT_GT(picked.ExpectPixels(), 20);
    // Frames are not traced for it.
    EXPECT_LE(picked.Scene.Mapper->GetNumberOfTraces(), 2);
  }
}

TEST(HighOrderPicker, KnowsThePointInClosedForm)
{
  Picked picked;
  picked.Scene.Mapper->SetFieldName("v");
  picked.Scene.Table->SetVectorModeToMagnitude();
  const testing::VtkRays rays(
    picked.Window.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
  const int i = 110;
  const int j = 120;
  const auto expected = CutScene::Meet(rays.At(i + 0.5, j + 0.5));
  ASSERT_EQ(expected.seen, CutScene::Seen::Cut);
  // The view was not rendered before. Any position within the pixel gives the pixel.
  ASSERT_NE(picked.Picker->Pick(i + 0.9, j + 0.2, 0.0, picked.Window.Renderer), 0);
  EXPECT_EQ(picked.Picker->GetActor(), picked.Scene.Cut);
  EXPECT_EQ(picked.Picker->GetMapper(), picked.Scene.Mapper);
  EXPECT_EQ(picked.Picker->GetDataSet(), picked.Scene.Grid);
  EXPECT_EQ(picked.Picker->GetElement(), 1000 + picked.Picker->GetCellId());
  EXPECT_STREQ(picked.Picker->GetFieldName(), "v");
  const double* x = picked.Picker->GetPickPosition();
  const Vec3 v = testing::FieldV(x[0], x[1], x[2]);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(x[c], expected.position[c], 1e-14);
    EXPECT_NEAR(picked.Picker->GetFieldValues()->GetComponent(0, c), v[c], 1e-14);
    EXPECT_NEAR(std::abs(picked.Picker->GetPickNormal()[c]), c == 2 ? 1.0 : 0.0, 1e-15);
  }
  EXPECT_NEAR(picked.Picker->GetValue(), glm::length(v), 1e-14);
}

TEST(HighOrderPicker, MissesAreMisses)
{
  Picked picked;
  ASSERT_TRUE(picked.Pick(110, 120));
  EXPECT_FALSE(picked.Pick(2, 2));
  ExpectNothing(picked.Picker);
  // Nothing is picked outside of the viewport, even where the camera's rays would meet the cut.
  ASSERT_TRUE(picked.Pick(110, 120));
  picked.Window.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  EXPECT_FALSE(picked.Pick(110, 120));
  ExpectNothing(picked.Picker);
  EXPECT_TRUE(picked.Pick(110 / 2 + Window::kWidth / 2, 120));
  // An actor that is not pickable, or not visible.
  picked.Window.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  picked.Scene.Cut->PickableOff();
  EXPECT_FALSE(picked.Pick(110, 120));
  picked.Scene.Cut->PickableOn();
  picked.Scene.Cut->GetProperty()->SetOpacity(0.0);
  EXPECT_FALSE(picked.Pick(110, 120));
}

TEST(HighOrderPicker, OtherGeometryHidesAndIsHidden)
{
  for (const bool parallel : { false, true })
  {
    Picked picked(parallel);
    picked.Window.Renderer->AddActor(picked.Scene.Sphere);
    const testing::VtkRays rays(
      picked.Window.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
    std::array<int, 3> count{};
    for (int j = 4; j < Window::kHeight; j += 23)
    {
      for (int i = 4; i < Window::kWidth; i += 23)
      {
        const auto expected = CutScene::Meet(rays.At(i + 0.5, j + 0.5));
        ++count[static_cast<std::size_t>(expected.seen)];
        ASSERT_EQ(picked.Pick(i, j), expected.seen != CutScene::Seen::Nothing) << i << ", " << j;
        if (expected.seen == CutScene::Seen::Cut)
        {
          ASSERT_EQ(picked.Picker->GetActor(), picked.Scene.Cut);
          ASSERT_EQ(picked.Picker->GetVerdict(), 1);
        }
        if (expected.seen == CutScene::Seen::Sphere)
        {
          ASSERT_EQ(picked.Picker->GetActor(), picked.Scene.Sphere);
          ASSERT_EQ(picked.Picker->GetVerdict(), 0);
          ASSERT_EQ(picked.Picker->GetElement(), -1);
        }
      }
    }
    for (const int pixels : count)
    {
      EXPECT_GT(pixels, 0);
    }
  }
}

TEST(HighOrderPicker, ActorsMayBeMoved)
{
  Picked picked;
  picked.Scene.Cut->SetPosition(0.1, 0.2, -0.1);
  picked.Scene.Cut->RotateZ(30.0);
  picked.Scene.Cut->RotateX(10.0);
  picked.Scene.Cut->SetScale(0.8);
  EXPECT_GT(picked.ExpectPixels(), 20);
  ASSERT_TRUE(picked.Pick(150, 120));
  const double* mapper = picked.Picker->GetMapperPosition();
  const double point[4] = { mapper[0], mapper[1], mapper[2], 1.0 };
  double world[4];
  picked.Scene.Cut->GetMatrix()->MultiplyPoint(point, world);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(picked.Picker->GetPickPosition()[c], world[c], 1e-14);
  }
  // The same by an assembly, whose parts VTK places only while they are drawn.
  Picked whole;
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(whole.Scene.Cut);
  assembly->SetPosition(0.1, 0.2, -0.1);
  assembly->RotateZ(30.0);
  assembly->RotateX(10.0);
  assembly->SetScale(0.8);
  whole.Window.Renderer->RemoveActor(whole.Scene.Cut);
  whole.Window.Renderer->AddActor(assembly);
  whole.Window.Renderer->GetActiveCamera()->SetClippingRange(
    picked.Window.Renderer->GetActiveCamera()->GetClippingRange());
  ASSERT_TRUE(whole.Pick(150, 120));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(whole.Picker->GetPickPosition()[c], world[c], 1e-14);
  }
}

TEST(HighOrderPicker, ClippingPlanesAndNearAndFarPlaneCut)
{
  Picked picked;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.0, 0.0);
  plane->SetNormal(1.0, 0.3, 0.0);
  picked.Scene.Mapper->AddClippingPlane(plane);
  const int clipped = picked.ExpectPixels();
  EXPECT_GT(clipped, 5);
  picked.Scene.Mapper->RemoveAllClippingPlanes();
  const int all = picked.ExpectPixels();
  EXPECT_GT(all, clipped);
  double range[2];
  picked.Window.Renderer->GetActiveCamera()->GetClippingRange(range);
  vtkCamera* camera = picked.Window.Renderer->GetActiveCamera();
  const double middle = camera->GetDistance();
  camera->SetClippingRange(middle, range[1]);
  EXPECT_GT(picked.ExpectPixels(), 5);
  // Beyond the far plane pixels have values, but nothing is drawn.
  camera->SetClippingRange(range[0], middle);
  picked.Window.Render();
  int cuts = 0;
  for (int j = 3; j < Window::kHeight; j += 19)
  {
    for (int i = 3; i < Window::kWidth; i += 17)
    {
      const bool drawn = picked.Window.Depth(i, j) < 1.0;
      EXPECT_EQ(picked.Pick(i, j), drawn);
      cuts += drawn ? 1 : 0;
    }
  }
  EXPECT_GT(cuts, 5);
  EXPECT_LT(cuts, all);
}

TEST(HighOrderPicker, NearestVisibleLayer)
{
  Picked picked;
  vtkNew<vtkPlane> above;
  above->SetOrigin(0.0, 0.0, 0.4);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(above);
  layer->SetFieldName("v");
  layer->SetOpacity(0.4);
  picked.Scene.Mapper->AddLayer(layer);
  ASSERT_TRUE(picked.Pick(150, 120));
  EXPECT_EQ(picked.Picker->GetLayer(), 1);
  EXPECT_STREQ(picked.Picker->GetFieldName(), "v");
  EXPECT_NEAR(picked.Picker->GetPickPosition()[2], 0.4, 1e-14);
  layer->SetOpacity(0.0);
  ASSERT_TRUE(picked.Pick(150, 120));
  EXPECT_EQ(picked.Picker->GetLayer(), 0);
  EXPECT_NEAR(picked.Picker->GetPickPosition()[2], 0.0, 1e-14);
  layer->SetOpacity(1.0);
  layer->VisibilityOff();
  ASSERT_TRUE(picked.Pick(150, 120));
  EXPECT_EQ(picked.Picker->GetLayer(), 0);
}

TEST(HighOrderPicker, ActorsOfAListNeedNotBeInTheRenderer)
{
  Picked picked;
  picked.Window.Renderer->RemoveActor(picked.Scene.Cut); // as those of a vtkHighOrderRayPass
  EXPECT_FALSE(picked.Pick(110, 120));
  picked.Picker->PickFromListOn();
  picked.Picker->AddPickList(picked.Scene.Cut);
  EXPECT_TRUE(picked.Pick(110, 120));
  EXPECT_EQ(picked.Picker->GetVerdict(), 1);
}

TEST(HighOrderPicker, RaysOfTheirOwn)
{
  Picked picked;
  double start[3] = { 0.3, -0.2, 0.7 };
  double end[3] = { 0.3, -0.2, -0.7 };
  ASSERT_NE(picked.Picker->Pick3DPoint(start, end, picked.Window.Renderer), 0);
  EXPECT_NEAR(picked.Picker->GetPickPosition()[0], 0.3, 1e-15);
  EXPECT_NEAR(picked.Picker->GetPickPosition()[2], 0.0, 1e-15);
  EXPECT_NEAR(picked.Picker->GetValue(), testing::FieldU(0.3, -0.2, 0.0), 1e-15);
  end[2] = 0.1;
  EXPECT_EQ(picked.Picker->Pick3DPoint(start, end, picked.Window.Renderer), 0);
  double down[4] = { 0.0, 1.0, 0.0, 0.0 };
  ASSERT_NE(picked.Picker->Pick3DRay(start, down, picked.Window.Renderer), 0);
  EXPECT_NEAR(picked.Picker->GetPickPosition()[1], -0.2, 1e-15);
}

TEST(HighOrderPicker, SaysWhatIsWrong)
{
  Picked picked;
  vtkNew<ErrorObserver> errors;
  picked.Picker->AddObserver(vtkCommand::ErrorEvent, errors);
  picked.Scene.Mapper->SetFieldName("pressure");
  EXPECT_FALSE(picked.Pick(110, 120));
  EXPECT_NE(errors->Text.find("'pressure'"), std::string::npos) << errors->Text;
  ExpectNothing(picked.Picker);
  picked.Scene.Mapper->SetFieldName("u");
  EXPECT_EQ(picked.Picker->Pick(110, 120, 0.0, nullptr), 0);
  EXPECT_NE(errors->Text.find("renderer"), std::string::npos) << errors->Text;
}
} // namespace pixelexact
