// SPDX-License-Identifier: BSD-3-Clause
// The mapper's contours, and what drawing them costs.
#include "CutScene.h"

#include "Frames/ContourLabels.h"
#include "vtkHighOrderLayer.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderWindowInteractor.h"

namespace pixelexact
{
namespace
{
using testing::Contains;
using testing::CutScene;
using testing::FieldU;
using testing::Rgb;
using testing::Window;

/// The cut alone, in white, with black lines.
class ContoursInWindow : public ::testing::Test
{
protected:
  ContoursInWindow()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Scene.Mapper->ScalarVisibilityOff();
    Scene.Cut->GetProperty()->SetColor(1.0, 1.0, 1.0);
    View.Renderer->AddActor(Scene.Cut);
    CutScene::Look(View.Renderer, false);
  }

  std::string Complaint()
  {
    Errors->Text.clear();
    View.RenderWindow->Render();
    return Errors->Text;
  }

  /// A line of a value goes through pixels that have lower and higher values at their corners.
  struct Corners
  {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
    bool seen = true;
  };
  Corners CornersOf(int x, int y)
  {
    const testing::VtkRays rays(View.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
    Corners corners;
    for (const int dx : { 0, 1 })
    {
      for (const int dy : { 0, 1 })
      {
        const Ray ray = rays.At(x + dx, y + dy);
        const Vec3 at = ray.origin - ray.origin.z / ray.direction.z * ray.direction;
        corners.seen = corners.seen && std::max(std::fabs(at.x), std::fabs(at.y)) < 1.0;
        const double value = FieldU(at.x, at.y, 0.0);
        corners.least = std::min(corners.least, value);
        corners.greatest = std::max(corners.greatest, value);
      }
    }
    return corners;
  }

  CutScene Scene;
  Window View;
  vtkNew<testing::ErrorObserver> Errors;
};

} // namespace

TEST_F(ContoursInWindow, GoWhereTheFieldHasTheirValues)
{
  Scene.Mapper->GenerateContourValues(5, -0.5, 1.0);
  Scene.Mapper->SetContourWidth(1.0);
  View.Render();
  vtkImageData* buffers = Scene.Mapper->GetBuffers();
  ASSERT_NE(buffers, nullptr);
  vtkDataArray* contour = buffers->GetPointData()->GetArray("Contour");
  ASSERT_NE(contour, nullptr);
  EXPECT_EQ(contour->GetDataType(), VTK_UNSIGNED_CHAR);
  int in = 0;
  for (int y = 0; y < Window::kHeight; ++y)
  {
    for (int x = 0; x < Window::kWidth; ++x)
    {
      const Corners corners = CornersOf(x, y);
      bool crossed = false;
      for (int i = 0; i < 5; ++i)
      {
        const double value = Scene.Mapper->GetContourValue(i);
        crossed = crossed || (corners.least < value && value < corners.greatest);
      }
      if (corners.seen && crossed)
      {
        ++in;
        EXPECT_EQ(contour->GetComponent(static_cast<vtkIdType>(y) * Window::kWidth + x, 0), 1.0);
        EXPECT_LT(View.Color(x, y)[0], 255) << x << " " << y;
      }
    }
  }
  EXPECT_GT(in, 200);
  EXPECT_GE(Scene.Mapper->GetNumberOfContourPixels(), in);
  EXPECT_EQ(Scene.Mapper->GetNumberOfContourJumpPixels(), 0);
}

TEST_F(ContoursInWindow, OtherContoursTraceNothing)
{
  Scene.Mapper->ScalarVisibilityOn();
  const auto expect = [&](int traces, int colorings)
  {
    View.Render();
    EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), traces);
    EXPECT_EQ(Scene.Mapper->GetNumberOfColorings(), colorings);
  };
  expect(1, 1);
  Scene.Mapper->GenerateContourValues(5, -0.5, 1.0);
  expect(1, 2);
  expect(1, 2);
  Scene.Mapper->SetContourValue(7, 0.3);
  expect(1, 3);
  Scene.Mapper->SetContourWidth(3.0);
  expect(1, 4);
  Scene.Mapper->SetContourColor(1.0, 0.0, 0.0);
  expect(1, 5);
  Scene.Mapper->SetColorOfContour(2, 0.0, 1.0, 0.0);
  expect(1, 6);
  Scene.Mapper->ContourScalarVisibilityOn();
  expect(1, 7);
  Scene.Mapper->ShowUndecidedContoursOn();
  expect(1, 8);
  Scene.Mapper->SetNumberOfContours(0);
  expect(1, 9);
  EXPECT_EQ(Scene.Mapper->GetNumberOfContourPixels(), 0);
}

/// The picture with contours that came later is that of a mapper that had them from the start.
TEST_F(ContoursInWindow, ComeLaterAsTheyComeAtOnce)
{
  CutScene other;
  Window wanted;
  for (CutScene* scene : { &Scene, &other })
  {
    scene->Mapper->ScalarVisibilityOn();
  }
  other.Mapper->GenerateContourValues(7, -0.5, 1.0);
  wanted.Renderer->AddActor(other.Cut);
  CutScene::Look(wanted.Renderer, false);
  wanted.Render();
  View.Render();
  Scene.Mapper->GenerateContourValues(3, 0.0, 1.0);
  View.Render();
  Scene.Mapper->GenerateContourValues(7, -0.5, 1.0);
  View.Render();
  for (int y = 0; y < Window::kHeight; ++y)
  {
    for (int x = 0; x < Window::kWidth; ++x)
    {
      ASSERT_EQ(View.Color(x, y), wanted.Color(x, y));
    }
  }
}

TEST_F(ContoursInWindow, ColorsAreOfEachValueOrTheTables)
{
  const double values[] = { 0.0, 0.5 };
  vtkNew<vtkDoubleArray> given;
  for (const double value : values)
  {
    given->InsertNextValue(value);
  }
  Scene.Mapper->SetContourValues(given);
  EXPECT_EQ(Scene.Mapper->GetNumberOfContours(), 2);
  EXPECT_EQ(Scene.Mapper->GetContourValues()[1], 0.5);
  Scene.Mapper->SetContourWidth(6.0);
  Scene.Mapper->SetColorOfContour(1, 1.0, 0.0, 0.0);
  const auto count = [&](const Rgb& color)
  {
    View.Render();
    int found = 0;
    for (int i = 0; i < Window::kWidth * Window::kHeight; ++i)
    {
      found += View.Color(i % Window::kWidth, i / Window::kWidth) == color ? 1 : 0;
    }
    return found;
  };
  EXPECT_GT(count({ 255, 0, 0 }), 50);
  EXPECT_GT(count({ 0, 0, 0 }), 50);
  Scene.Mapper->RemoveColorsOfContours();
  EXPECT_EQ(count({ 255, 0, 0 }), 0);
  Scene.Mapper->ScalarVisibilityOn();
  Scene.Mapper->ContourScalarVisibilityOn();
  EXPECT_EQ(count({ 0, 0, 0 }), 0);
}

/// A value that is set twice is a line that is drawn, and labelled, once.
TEST_F(ContoursInWindow, AreDrawnOnceForEachValue)
{
  const auto picture = [&]
  {
    View.Render();
    std::vector<Rgb> colors;
    for (int i = 0; i < Window::kWidth * Window::kHeight; ++i)
    {
      colors.push_back(View.Color(i % Window::kWidth, i / Window::kWidth));
    }
    return colors;
  };
  for (const bool labels : { false, true })
  {
    Scene.Mapper->SetContourLabels(labels);
    Scene.Mapper->RemoveColorsOfContours();
    Scene.Mapper->GenerateContourValues(1, 0.25, 0.25);
    const std::vector<Rgb> once = picture();
    Scene.Mapper->GenerateContourValues(3, 0.25, 0.25);
    EXPECT_TRUE(picture() == once) << labels;
    Scene.Mapper->SetColorOfContour(1, 1.0, 0.0, 0.0);
    EXPECT_TRUE(picture() == once) << labels;
  }
}

/// A surface of one colour has lines by the table as well, of the component that it chooses.
TEST_F(ContoursInWindow, ColorsAreTheTablesWhereTheSurfaceHasOne)
{
  Scene.Mapper->SetContourValue(0, 0.5);
  Scene.Mapper->SetContourWidth(6.0);
  Scene.Mapper->ContourScalarVisibilityOn();
  const int gray = static_cast<int>(std::lround(255.0 * (0.5 + 1.0) / 3.0));
  const auto count = [&](int wanted)
  {
    View.Render();
    int found = 0;
    for (int i = 0; i < Window::kWidth * Window::kHeight; ++i)
    {
      found +=
        std::abs(View.Color(i % Window::kWidth, i / Window::kWidth)[0] - wanted) <= 1 ? 1 : 0;
    }
    return found;
  };
  EXPECT_GT(count(gray), 50);
  // A range that follows from the field, as where the surface is coloured.
  Scene.Mapper->SetRangeModeToField();
  Scene.Mapper->ScalarVisibilityOn();
  View.Render();
  const std::vector<double> range(
    Scene.Mapper->GetScalarRange(), Scene.Mapper->GetScalarRange() + 2);
  Scene.Mapper->SetScalarRange(-7.0, 8.0);
  Scene.Mapper->SetRangeModeToField();
  Scene.Mapper->ScalarVisibilityOff();
  EXPECT_GT(
    count(static_cast<int>(std::lround(255.0 * (0.5 - range[0]) / (range[1] - range[0])))), 50);
  EXPECT_EQ(std::vector<double>(Scene.Table->GetRange(), Scene.Table->GetRange() + 2), range);
  // The same for a layer.
  Scene.Mapper->ScalarVisibilityOn();
  Scene.Mapper->SetScalarRange(-1.0, 2.0);
  Scene.Mapper->SetCutFunction(nullptr);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(Scene.Function);
  layer->ScalarVisibilityOff();
  Scene.Mapper->AddLayer(layer);
  EXPECT_GT(count(gray), 50);
}

TEST_F(ContoursInWindow, AreOfTheTablesComponentWhereTheSurfaceHasOneColor)
{
  Scene.Mapper->SetFieldName("v");
  Scene.Mapper->SetContourValue(0, 1.25);
  Scene.Table->SetVectorModeToMagnitude();
  View.Render();
  const vtkIdType solid = Scene.Mapper->GetNumberOfContourPixels();
  Scene.Mapper->ScalarVisibilityOn();
  View.Render();
  const vtkIdType ofMagnitude = Scene.Mapper->GetNumberOfContourPixels();
  Scene.Table->SetVectorModeToComponent();
  View.Render();
  ASSERT_NE(Scene.Mapper->GetNumberOfContourPixels(), ofMagnitude);
  EXPECT_EQ(solid, ofMagnitude);
}

TEST_F(ContoursInWindow, OfLayersAreTheirOwn)
{
  Scene.Mapper->SetCutFunction(nullptr);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(Scene.Function);
  layer->ScalarVisibilityOff();
  Scene.Mapper->AddLayer(layer);
  Scene.Mapper->SetContourValue(0, 0.25);
  View.Render();
  const vtkIdType one = Scene.Mapper->GetNumberOfContourPixels();
  EXPECT_GT(one, 20);
  layer->GenerateContourValues(6, -0.5, 1.0);
  EXPECT_EQ(layer->GetNumberOfContours(), 6);
  EXPECT_EQ(layer->GetContourValue(5), 1.0);
  View.Render();
  EXPECT_GT(Scene.Mapper->GetNumberOfContourPixels(), one);
  layer->ContourVisibilityOff();
  View.Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfContourPixels(), 0);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 1);
  // The layer uses the mapper's colour, whatever colours its own contours have.
  layer->ContourVisibilityOn();
  Scene.Mapper->SetContourWidth(6.0);
  for (const int own : { 1, 0 })
  {
    Scene.Mapper->SetNumberOfContours(own);
    Scene.Mapper->SetColorOfContour(0, 1.0, 0.0, 0.0);
    View.Render();
    int black = 0;
    for (int i = 0; i < Window::kWidth * Window::kHeight; ++i)
    {
      black += View.Color(i % Window::kWidth, i / Window::kWidth) == Rgb{ 0, 0, 0 } ? 1 : 0;
    }
    EXPECT_GT(black, 50) << own;
  }
}

/// Lines are on the nearest sheet and go with it.
TEST_F(ContoursInWindow, AreDrawnOnWhatIsSeenThrough)
{
  Scene.Mapper->SetCutFunction(nullptr);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(Scene.Function);
  layer->SetOpacity(0.5);
  layer->ScalarVisibilityOff();
  vtkNew<vtkPlane> behind;
  behind->SetOrigin(0.0, 0.0, -0.5);
  behind->SetNormal(0.0, 0.0, 1.0);
  Scene.Mapper->AddLayer(layer);
  Scene.Mapper->AddCutFunction(behind);
  View.Render();
  const Rgb before = View.Color(Window::kWidth / 2, Window::kHeight / 2);
  Scene.Mapper->GenerateContourValues(400, -0.5, 1.0);
  Scene.Mapper->SetContourWidth(8.0);
  View.Render();
  EXPECT_GT(before[0], 100);
  EXPECT_EQ(View.Color(Window::kWidth / 2, Window::kHeight / 2), (Rgb{ 0, 0, 0 }));
}

TEST_F(ContoursInWindow, ComeWithTheCompleteFrame)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(View.RenderWindow);
  Scene.Mapper->GenerateContourValues(5, -0.5, 1.0);
  View.Render();
  const vtkIdType pixels = Scene.Mapper->GetNumberOfContourPixels();
  EXPECT_GT(pixels, 0);
  View.RenderWindow->SetDesiredUpdateRate(1e9);
  View.Renderer->GetActiveCamera()->Azimuth(20.0);
  View.Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfContourPixels(), 0);
  View.RenderWindow->SetDesiredUpdateRate(1e-4);
  View.Render();
  EXPECT_GT(Scene.Mapper->GetNumberOfContourPixels(), pixels / 2);
}

/// Values along the lines: other pixels, no rays, and none where something is seen through.
TEST_F(ContoursInWindow, HaveLabels)
{
  const auto dark = [&]
  {
    View.Render();
    int count = 0;
    for (int i = 0; i < Window::kWidth * Window::kHeight; ++i)
    {
      count += View.Color(i % Window::kWidth, i / Window::kWidth)[2] < 128 &&
          View.Color(i % Window::kWidth, i / Window::kWidth)[0] > 0
        ? 1
        : 0;
    }
    return count;
  };
  Scene.Mapper->GenerateContourValues(4, -0.25, 1.0);
  const int without = dark();
  const vtkIdType in = Scene.Mapper->GetNumberOfContourPixels();
  const vtkIdType traces = Scene.Mapper->GetNumberOfTraces();
  Scene.Mapper->ContourLabelsOn();
  dark();
  EXPECT_EQ(Scene.Mapper->GetNumberOfContourPixels(), in);
  const vtkIdType withNormals = Scene.Mapper->GetNumberOfTraces();
  EXPECT_LE(withNormals, traces + 1);
  Scene.Mapper->SetContourLabelSize(20);
  EXPECT_NE(dark(), without);
  Scene.Mapper->SetContourLabelSize(10);
  EXPECT_NE(dark(), without);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), withNormals);
  EXPECT_EQ(Complaint(), "");
  Scene.Mapper->SetContourLabelSize(100);
  EXPECT_TRUE(Contains(Complaint(), "6 to 72")) << Errors->Text;
}

TEST_F(ContoursInWindow, LabelsThatAreNotWrittenAreTold)
{
  Scene.Mapper->AddObserver(vtkCommand::WarningEvent, Errors);
  Scene.Mapper->SetContourValue(0, 0.25);
  Scene.Mapper->ContourLabelsOn();
  // A single plane hides nothing.
  Scene.Cut->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(Complaint(), "");
  vtkNew<vtkPlane> behind;
  behind->SetOrigin(0.0, 0.0, -0.5);
  behind->SetNormal(0.0, 0.0, 1.0);
  Scene.Mapper->AddCutFunction(behind);
  EXPECT_TRUE(Contains(Complaint(), "ContourLabels")) << Errors->Text;
  // A size that labels cannot have is refused even then.
  Scene.Mapper->SetContourLabelSize(5);
  EXPECT_TRUE(Contains(Complaint(), "6 to 72")) << Errors->Text;
}

TEST(ContourLabels, AreShortAndDistinguishValues)
{
  using Texts = std::vector<std::string>;
  EXPECT_EQ(
    LabelTexts({ 0.1, 0.25, -3.0, 1e6, -0.0 }), (Texts{ "0.1", "0.25", "-3", "1e+06", "0" }));
  EXPECT_EQ(LabelTexts({ 1.0 / 3.0, 2.0 / 3.0 }), (Texts{ "0.333", "0.667" }));
  EXPECT_EQ(LabelTexts({ 100.1, 100.2 }), (Texts{ "100.1", "100.2" }));
  EXPECT_EQ(LabelTexts({ 2.0, 2.0 }), (Texts{ "2", "2" }));
}

TEST_F(ContoursInWindow, RefuseWhatCannotBeDrawn)
{
  Scene.Mapper->SetContourValue(0, 0.5);
  EXPECT_EQ(Complaint(), "");
  Scene.Mapper->SetContourValue(0, std::nan(""));
  EXPECT_TRUE(Contains(Complaint(), "finite")) << Errors->Text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  Scene.Mapper->SetContourValue(0, 0.5);
  Scene.Mapper->SetContourWidth(0.0);
  EXPECT_TRUE(Contains(Complaint(), "0.1 to 32")) << Errors->Text;
  Scene.Mapper->SetContourWidth(1.0);
  EXPECT_EQ(Complaint(), "");
  Scene.Mapper->SetContourValue(-1, 0.5);
  EXPECT_TRUE(Contains(Errors->Text, "counted from 0")) << Errors->Text;
  EXPECT_TRUE(std::isnan(Scene.Mapper->GetContourValue(1)));
}
} // namespace pixelexact
