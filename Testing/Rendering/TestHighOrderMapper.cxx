// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkScalarBarActor.h"
#include "vtkTypeInt64Array.h"

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Rgb;
using testing::SameBytes;
using testing::Window;

} // namespace

TEST(HighOrderMapper, BuffersAreTheTracersBitForBit)
{
  for (const bool parallel : { false, true })
  {
    CutScene scene;
    Window window;
    window.Renderer->AddActor(scene.Cut);
    EXPECT_EQ(scene.Mapper->GetBuffers(), nullptr);
    CutScene::Look(window.Renderer, parallel);
    window.Render();
    const Frame frame = scene.Traced(window.Renderer, Window::kWidth, Window::kHeight,
      Buffer::Value | Buffer::Position | Buffer::Normal | Buffer::Xi | Buffer::Element |
        Buffer::Depth | Buffer::Verdict);
    vtkImageData* image = scene.Mapper->GetBuffers();
    ASSERT_NE(image, nullptr);
    vtkPointData* data = image->GetPointData();
    EXPECT_TRUE(SameBytes(frame.centres.value, data->GetArray("Value")));
    EXPECT_TRUE(SameBytes(frame.centres.position, data->GetArray("Position")));
    EXPECT_TRUE(SameBytes(frame.centres.normal, data->GetArray("Normal")));
    EXPECT_TRUE(SameBytes(frame.centres.xi, data->GetArray("Xi")));
    EXPECT_TRUE(SameBytes(frame.centres.depth, data->GetArray("Depth")));
    EXPECT_TRUE(SameBytes(frame.centres.verdict, data->GetArray("Verdict")));
    auto* element = vtkTypeInt64Array::SafeDownCast(data->GetArray("Element"));
    ASSERT_NE(element, nullptr);
    for (std::size_t i = 0; i < frame.centres.Size(); ++i)
    {
      const std::int64_t ours = frame.centres.element[i];
      ASSERT_EQ(element->GetValue(static_cast<vtkIdType>(i)), ours < 0 ? -1 : 1000 + ours);
    }
    ASSERT_NE(data->GetArray("Color"), nullptr);
    EXPECT_EQ(data->GetArray("Color")->GetNumberOfComponents(), 4);
    // A second request does no work.
    const vtkIdType traces = scene.Mapper->GetNumberOfTraces();
    EXPECT_EQ(scene.Mapper->GetBuffers(), image);
    EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), traces);
    // Cuts do not need the table of faces.
    EXPECT_FALSE(HighOrderModel::From(scene.Grid)->HasFaces());
  }
}

TEST(HighOrderMapper, OnlyWhatChangedIsDoneAgain)
{
  CutScene scene;
  Window window;
  window.Renderer->AddActor(scene.Cut);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(scene.Mapper->GetLookupTable());
  window.Renderer->AddActor(bar);
  CutScene::Look(window.Renderer, false);
  const auto expect = [&](int models, int traces, int colorings)
  {
    window.RenderWindow->Render();
    EXPECT_EQ(scene.Mapper->GetNumberOfModelBuilds(), models);
    EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), traces);
    EXPECT_EQ(scene.Mapper->GetNumberOfColorings(), colorings);
  };
  expect(1, 1, 1);
  expect(1, 1, 1);
  scene.Mapper->SetScalarRange(0.0, 1.0);
  expect(1, 1, 2);
  scene.Table->SetValueRange(1.0, 0.0);
  scene.Table->ForceBuild();
  scene.Table->Modified();
  expect(1, 1, 3);
  scene.Mapper->UseLookupTableScalarRangeOn();
  expect(1, 1, 3);
  scene.Cut->GetProperty()->SetOpacity(0.7);
  expect(1, 1, 3);
  window.Renderer->GetActiveCamera()->SetClippingRange(0.1, 100.0);
  expect(1, 1, 3);
  window.Renderer->GetActiveCamera()->Azimuth(5.0);
  expect(1, 2, 4);
  scene.Function->SetOrigin(0.0, 0.0, 0.25);
  expect(1, 3, 5);
  scene.Mapper->SetFieldName("nan");
  expect(1, 4, 6);
  scene.Mapper->SetFieldName("v");
  expect(1, 5, 7);
  scene.Table->SetVectorComponent(1);
  expect(1, 6, 8);
  scene.Grid->Modified();
  window.RenderWindow->Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfModelBuilds(), 2);
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 7);
  window.RenderWindow->SetSize(200, 100);
  window.RenderWindow->Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 8);
}

TEST(HighOrderMapper, ClippingPlanesAndTheNearPlaneShowWhatIsBehind)
{
  CutScene scene;
  Window window;
  vtkNew<vtkPlane> behind;
  behind->SetOrigin(0.0, 0.0, -0.5);
  scene.Mapper->AddCutFunction(behind);
  vtkNew<vtkPlane> kept;
  kept->SetNormal(1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(kept);
  window.Renderer->AddActor(scene.Cut);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.2);
  const auto heights = [&]
  {
    window.Render();
    vtkDataArray* position = scene.Mapper->GetBuffers()->GetPointData()->GetArray("Position");
    const vtkIdType row = static_cast<vtkIdType>(Window::kHeight / 2) * Window::kWidth;
    return std::array{ position->GetComponent(row + Window::kWidth / 2 - 40, 2),
      position->GetComponent(row + Window::kWidth / 2 + 40, 2) };
  };
  window.Renderer->ResetCameraClippingRange();
  EXPECT_TRUE(std::isnan(heights()[0]));
  EXPECT_EQ(heights()[1], 0.0);
  camera->SetClippingRange(5.2, 10.0); // the near plane between the two cuts
  EXPECT_TRUE(std::isnan(heights()[0]));
  EXPECT_EQ(heights()[1], -0.5);
  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_EQ(heights()[0], -0.5);
  camera->SetClippingRange(4.0, 10.0);
  EXPECT_EQ(heights()[0], 0.0);
}

TEST(HighOrderMapper, FieldsComponentsAndColors)
{
  CutScene scene;
  Window window;
  window.Renderer->AddActor(scene.Cut);
  CutScene::Look(window.Renderer, false);
  const auto expectValues = [&](const char* field, int component)
  {
    window.RenderWindow->Render();
    const Frame frame = scene.Traced(
      window.Renderer, Window::kWidth, Window::kHeight, Buffer::Value, field, component);
    return SameBytes(
      frame.centres.value, scene.Mapper->GetBuffers()->GetPointData()->GetArray("Value"));
  };
  scene.Mapper->SetFieldName("v");
  EXPECT_TRUE(expectValues("v", 0));
  scene.Table->SetVectorComponent(2);
  EXPECT_TRUE(expectValues("v", 2));
  scene.Table->SetVectorModeToMagnitude();
  EXPECT_TRUE(expectValues("v", kMagnitude));
  // VTK's own ways to choose.
  scene.Mapper->SetFieldName(nullptr);
  EXPECT_TRUE(expectValues("u", 0));
  scene.Mapper->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "v");
  EXPECT_TRUE(expectValues("v", kMagnitude));
  scene.Mapper->SelectColorArray("u");
  EXPECT_TRUE(expectValues("u", 0));
  scene.Mapper->SelectColorArray(1);
  EXPECT_TRUE(expectValues("v", kMagnitude));

  scene.Mapper->SetFieldName("nan");
  scene.Table->SetNanColor(0.0, 1.0, 0.0, 1.0);
  scene.Table->Modified();
  scene.Function->SetOrigin(0.0, 0.0, -0.25);
  window.Render();
  const Frame frame = scene.Traced(window.Renderer, Window::kWidth, Window::kHeight, Buffer::Value);
  int green = 0;
  for (int j = 0; j < Window::kHeight; ++j)
  {
    for (int i = 0; i < Window::kWidth; ++i)
    {
      green += window.Color(i, j) == Rgb{ 0, 255, 0 } ? 1 : 0;
    }
  }
  EXPECT_GT(green, 500);

  scene.Mapper->SetFieldName("u");
  scene.Mapper->ScalarVisibilityOff();
  scene.Cut->GetProperty()->SetColor(1.0, 0.5, 0.0);
  window.Render();
  EXPECT_EQ(window.Color(Window::kWidth / 2, Window::kHeight / 2), (Rgb{ 255, 128, 0 }));
}

TEST(HighOrderMapper, BoundsAreTheDomains)
{
  CutScene scene;
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], i % 2 == 0 ? -1.0 : 1.0, 1e-12);
  }
  vtkNew<vtkHighOrderMapper> empty;
  EXPECT_GT(empty->GetBounds()[0], empty->GetBounds()[1]);
}
} // namespace pixelexact
