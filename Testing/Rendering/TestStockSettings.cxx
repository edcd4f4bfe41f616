// SPDX-License-Identifier: BSD-3-Clause
// What stock mappers, properties and actors let users set: honoured, refused, or said to have no
// effect. The table is in Module/Documentation/windows.md.
#include "CutScene.h"

#include "vtkHighOrderLayer.h"
#include "vtkHighOrderPicker.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProperty.h"
#include "vtkSphere.h"
#include "vtkTexture.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::ErrorObserver;
using testing::Rgb;
using testing::SameBytes;

class StockSettings : public ::testing::Test
{
protected:
  StockSettings()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Scene.Mapper->AddObserver(vtkCommand::WarningEvent, Warnings);
    Window.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Window.Renderer, false);
  }

  void Render()
  {
    Errors->Text.clear();
    Warnings->Text.clear();
    Window.Render();
  }
  std::vector<Rgb> Picture()
  {
    std::vector<Rgb> colors;
    for (int y = 0; y < testing::Window::kHeight; ++y)
    {
      for (int x = 0; x < testing::Window::kWidth; ++x)
      {
        colors.push_back(Window.Color(x, y));
      }
    }
    return colors;
  }
  /// Whether the values shown are those of a field and component.
  bool Shows(const char* field, int component)
  {
    Render();
    vtkImageData* buffers = Scene.Mapper->GetBuffers();
    const Frame frame = Scene.Traced(Window.Renderer, testing::Window::kWidth,
      testing::Window::kHeight, Buffer::Value, field, component);
    return buffers != nullptr &&
      SameBytes(frame.centres.value, buffers->GetPointData()->GetArray("Value"));
  }
  void ExpectRange(double lower, double upper, double tolerance)
  {
    Render();
    EXPECT_EQ(Errors->Text, "");
    EXPECT_NEAR(Scene.Table->GetRange()[0], lower, tolerance);
    EXPECT_NEAR(Scene.Table->GetRange()[1], upper, tolerance);
    EXPECT_EQ(Scene.Mapper->GetScalarRange()[0], Scene.Table->GetRange()[0]);
    EXPECT_EQ(Scene.Mapper->GetScalarRange()[1], Scene.Table->GetRange()[1]);
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<ErrorObserver> Errors;
  vtkNew<ErrorObserver> Warnings;
};
} // namespace

TEST_F(StockSettings, ArrayComponentIsHonoured)
{
  Scene.Mapper->SetFieldName(nullptr);
  Scene.Mapper->ColorByArrayComponent("v", 2);
  EXPECT_TRUE(Shows("v", 2));
  Scene.Mapper->SetArrayComponent(1);
  EXPECT_TRUE(Shows("v", 1));
  // As in stock mappers, the array's choice precedes that of the table.
  Scene.Table->SetVectorModeToMagnitude();
  EXPECT_TRUE(Shows("v", 1));
  Scene.Mapper->SetArrayComponent(0);
  EXPECT_TRUE(Shows("v", 0));
  Scene.Mapper->SelectColorArray("v");
  EXPECT_TRUE(Shows("v", kMagnitude));
  Scene.Mapper->ColorByArrayComponent(1, 2);
  EXPECT_TRUE(Shows("v", 2));
  Scene.Mapper->SetFieldName("v");
  Scene.Mapper->SetArrayComponent(1);
  EXPECT_TRUE(Shows("v", 1));
  Scene.Mapper->SetArrayComponent(-1);
  EXPECT_TRUE(Shows("v", kMagnitude));
}

TEST_F(StockSettings, ComponentsThatAreNotThereAreRefused)
{
  for (const int component : { 3, 7 })
  {
    Scene.Mapper->SetFieldName("v");
    Scene.Mapper->SetArrayComponent(component);
    Render();
    const std::string number = "component " + std::to_string(component);
    EXPECT_NE(Errors->Text.find(number), std::string::npos) << Errors->Text;
    EXPECT_NE(Errors->Text.find("3 components"), std::string::npos) << Errors->Text;
    EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  }
  Scene.Mapper->SetFieldName("u");
  Render();
  EXPECT_NE(Errors->Text.find("1 component"), std::string::npos) << Errors->Text;
}

TEST_F(StockSettings, ColorsThatAreNotAFieldsAreRefused)
{
  const auto expect = [&](bool refused, const char* text)
  {
    Render();
    EXPECT_EQ(Errors->Text.find(text) != std::string::npos, refused) << Errors->Text;
    EXPECT_EQ(Scene.Mapper->GetBuffers() == nullptr, refused);
  };
  for (const int mode : { VTK_SCALAR_MODE_USE_CELL_DATA, VTK_SCALAR_MODE_USE_CELL_FIELD_DATA,
         VTK_SCALAR_MODE_USE_FIELD_DATA })
  {
    Scene.Mapper->SetScalarMode(mode);
    expect(true, "ScalarModeToDefault");
  }
  for (const int mode : { VTK_SCALAR_MODE_DEFAULT, VTK_SCALAR_MODE_USE_POINT_DATA,
         VTK_SCALAR_MODE_USE_POINT_FIELD_DATA })
  {
    Scene.Mapper->SetScalarMode(mode);
    expect(false, "ScalarMode");
  }
  Scene.Mapper->SetColorModeToDirectScalars();
  expect(true, "ColorModeToMapScalars");
  // No colours are requested then.
  Scene.Mapper->ScalarVisibilityOff();
  expect(false, "ColorMode");
  Scene.Mapper->ScalarVisibilityOn();
  Scene.Mapper->SetColorModeToMapScalars();
  expect(false, "ColorMode");
  Scene.Table->SetVectorModeToRGBColors();
  expect(true, "VectorMode");
}

TEST_F(StockSettings, WhatHasNoEffectIsSaidOnce)
{
  Render();
  EXPECT_EQ(Warnings->Text, "");
  const std::vector<Rgb> expected = Picture();
  vtkProperty* property = Scene.Cut->GetProperty();
  struct Setting
  {
    const char* name;
    std::function<void(bool)> set;
  };
  vtkNew<vtkProperty> back;
  vtkNew<vtkTexture> texture;
  const Setting settings[] = {
    { "Representation",
      [&](bool on) { property->SetRepresentation(on ? VTK_POINTS : VTK_SURFACE); } },
    { "Representation",
      [&](bool on) { property->SetRepresentation(on ? VTK_WIREFRAME : VTK_SURFACE); } },
    { "InterpolationToPBR",
      [&](bool on) { property->SetInterpolation(on ? VTK_PBR : VTK_GOURAUD); } },
    { "BackfaceCulling", [&](bool on) { property->SetBackfaceCulling(on); } },
    { "FrontfaceCulling", [&](bool on) { property->SetFrontfaceCulling(on); } },
    { "BackfaceProperty",
      [&](bool on) { Scene.Cut->SetBackfaceProperty(on ? back.Get() : nullptr); } },
    { "VertexVisibility", [&](bool on) { property->SetVertexVisibility(on); } },
    { "Texture", [&](bool on) { Scene.Cut->SetTexture(on ? texture.Get() : nullptr); } },
    { "Texture",
      [&](bool on)
      { on ? property->SetTexture("noise", texture) : property->RemoveTexture("noise"); } },
    { "ShaderProperty",
      [&](bool on)
      {
        vtkShaderProperty* shaders = Scene.Cut->GetShaderProperty();
        on ? shaders->AddFragmentShaderReplacement("//VTK::Color::Impl", true, "", false)
           : shaders->ClearAllFragmentShaderReplacements();
      } },
  };
  for (const Setting& setting : settings)
  {
    setting.set(true);
    Render();
    EXPECT_NE(Warnings->Text.find(setting.name), std::string::npos)
      << setting.name << ": " << Warnings->Text;
    EXPECT_EQ(Picture(), expected) << setting.name;
    Render();
    EXPECT_EQ(Warnings->Text, "") << setting.name;
    setting.set(false);
    Render();
    EXPECT_EQ(Warnings->Text, "") << setting.name;
  }
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 1);
}

TEST_F(StockSettings, WhatHasNoMeaningChangesNothing)
{
  Render();
  const std::vector<Rgb> expected = Picture();
  vtkProperty* property = Scene.Cut->GetProperty();
  Scene.Mapper->InterpolateScalarsBeforeMappingOn();
  Scene.Mapper->SetFieldDataTupleId(3);
  Scene.Mapper->SetResolveCoincidentTopologyPolygonOffsetFaces(0);
  Scene.Mapper->SetRelativeCoincidentTopologyLineOffsetParameters(5.0, 5.0);
  Scene.Mapper->SetRelativeCoincidentTopologyPointOffsetParameter(5.0);
  property->SetPointSize(10.0F);
  property->SetLineWidth(10.0F);
  property->SetLineStipplePattern(0x0f0f);
  property->RenderPointsAsSpheresOn();
  property->RenderLinesAsTubesOn();
  property->SetInterpolationToFlat();
  Render();
  EXPECT_EQ(Warnings->Text, "");
  EXPECT_EQ(Errors->Text, "");
  EXPECT_EQ(Picture(), expected);
  Scene.Mapper->SetResolveCoincidentTopologyPolygonOffsetFaces(1);
}

TEST_F(StockSettings, ForcedPhasesDrawTheSame)
{
  Render();
  const std::vector<Rgb> expected = Picture();
  Scene.Cut->ForceTranslucentOn();
  Render();
  EXPECT_EQ(Picture(), expected);
  Scene.Cut->ForceTranslucentOff();
  Scene.Cut->ForceOpaqueOn();
  Render();
  EXPECT_EQ(Picture(), expected);

  // A layer that is seen through, where there is but one phase.
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.5);
  vtkNew<vtkHighOrderLayer> glass;
  glass->SetCutFunction(sphere);
  glass->SetOpacity(0.4);
  Scene.Mapper->AddLayer(glass);
  // Without depth peeling VTK's translucent phase blends two sheets by an estimate.
  Window.Renderer->UseDepthPeelingOn();
  Window.RenderWindow->SetAlphaBitPlanes(1);
  Scene.Cut->ForceOpaqueOff();
  Render();
  const std::vector<Rgb> sheets = Picture();
  EXPECT_NE(sheets, expected);
  const auto expectSheets = [&]
  {
    Render();
    const std::vector<Rgb> picture = Picture();
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(picture[i][c], sheets[i][c], 2) << i;
      }
    }
  };
  Scene.Cut->ForceOpaqueOn();
  expectSheets();
  Scene.Cut->ForceOpaqueOff();
  Scene.Cut->ForceTranslucentOn();
  expectSheets();
}

TEST_F(StockSettings, MeshesWithoutFieldAreCutInTheActorsColor)
{
  Scene.Mapper->ScalarVisibilityOff();
  Scene.Cut->GetProperty()->SetColor(1.0, 0.5, 0.0);
  Render();
  const std::vector<Rgb> expected = Picture();
  vtkNew<vtkUnstructuredGrid> bare;
  bare->ShallowCopy(Scene.Grid);
  vtkFieldData* data = bare->GetFieldData();
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = data->GetArrayName(i);
    if (name.find("PixelExact.Field") != std::string::npos)
    {
      data->RemoveArray(name.c_str());
    }
  }
  Scene.Mapper->SetInputData(bare);
  Scene.Mapper->SetFieldName(nullptr);
  Render();
  EXPECT_EQ(Errors->Text, "");
  EXPECT_EQ(Picture(), expected);
  vtkPointData* buffers = Scene.Mapper->GetBuffers()->GetPointData();
  EXPECT_EQ(buffers->GetArray("Value"), nullptr);
  EXPECT_NE(buffers->GetArray("Element"), nullptr);
  vtkNew<vtkHighOrderPicker> picker;
  EXPECT_EQ(picker->Pick(
              0.5 * testing::Window::kWidth, 0.5 * testing::Window::kHeight, 0.0, Window.Renderer),
    1);
  EXPECT_GE(picker->GetElement(), 1000);
  EXPECT_TRUE(std::isnan(picker->GetValue()));
  EXPECT_EQ(picker->GetFieldValues()->GetNumberOfTuples(), 0);
  // Colours need one.
  Scene.Mapper->ScalarVisibilityOn();
  Render();
  EXPECT_NE(Errors->Text.find("ScalarVisibilityOff"), std::string::npos) << Errors->Text;
}

TEST_F(StockSettings, EdgeVisibilityDrawsWhereElementsMeet)
{
  // Off the elements' faces.
  Scene.Function->SetOrigin(0.0, 0.0, 0.3);
  Render();
  const std::vector<Rgb> plain = Picture();
  Scene.Cut->GetProperty()->EdgeVisibilityOn();
  Scene.Cut->GetProperty()->SetEdgeColor(0.0, 1.0, 0.0);
  Render();
  EXPECT_EQ(Warnings->Text, "");
  const std::vector<Rgb> edges = Picture();
  vtkDataArray* position = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Position");
  // The lines' part of the pixels, whose colours are mixed with theirs.
  const auto covered = [&]
  {
    double sum = 0.0;
    const std::vector<Rgb> shown = Picture();
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      if (shown[i] == plain[i])
      {
        continue;
      }
      const double* x = position->GetTuple3(static_cast<vtkIdType>(i));
      // The edges are at inner faces and at the mesh's boundary.
      EXPECT_LT(
        std::min({ std::abs(x[0]), std::abs(x[1]), 1.0 - std::abs(x[0]), 1.0 - std::abs(x[1]) }),
        0.1)
        << x[0] << ", " << x[1];
      sum += (plain[i][0] - shown[i][0]) / std::max(1.0, static_cast<double>(plain[i][0]));
    }
    return sum;
  };
  const double thin = covered();
  EXPECT_GT(thin, 100.0);
  // Another width and colour trace nothing.
  const vtkIdType before = Scene.Mapper->GetNumberOfTraces();
  Scene.Cut->GetProperty()->SetLineWidth(3.0F);
  Render();
  EXPECT_NEAR(covered() / thin, 3.0, 0.2);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), before);
  Scene.Cut->GetProperty()->SetLineWidth(1.0F);
  Scene.Cut->GetProperty()->SetEdgeColor(0.0, 0.0, 1.0);
  const vtkIdType traces = Scene.Mapper->GetNumberOfTraces();
  Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), traces);
  EXPECT_NE(Picture(), edges);
  Scene.Cut->GetProperty()->EdgeVisibilityOff();
  Render();
  EXPECT_EQ(Picture(), plain);

  Scene.Cut->GetProperty()->EdgeVisibilityOn();
  Scene.Cut->GetProperty()->SetOpacity(0.5);
  Render();
  EXPECT_EQ(Warnings->Text, "");
  const auto differing = [](const std::vector<Rgb>& a, const std::vector<Rgb>& b)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      count += a[i] == b[i] ? 0 : 1;
    }
    return count;
  };
  // Lines that are switched on where a curved surface is seen through are on its nearest sheet.
  vtkNew<vtkSphere> ball;
  ball->SetRadius(0.5);
  Scene.Cut->GetProperty()->EdgeVisibilityOff();
  Scene.Mapper->SetCutFunction(ball);
  Render();
  const std::vector<Rgb> glass = Picture();
  Scene.Cut->GetProperty()->EdgeVisibilityOn();
  Render();
  EXPECT_EQ(Warnings->Text, "");
  const std::size_t lines = differing(Picture(), glass);
  EXPECT_GT(lines, 50U);
  EXPECT_LT(lines, glass.size() / 10);
  // Lines follow the window's dots per inch, as letters of VTK do.
  Window.RenderWindow->SetDPI(144);
  Render();
  EXPECT_NEAR(
    static_cast<double>(differing(Picture(), glass)) / static_cast<double>(lines), 2.0, 0.8);
  Window.RenderWindow->SetDPI(72);
  Scene.Cut->GetProperty()->SetLineWidth(100.0F);
  Render();
  EXPECT_NE(Errors->Text.find("line width of 100 pixels"), std::string::npos) << Errors->Text;
}

TEST_F(StockSettings, LogarithmsOfWhatIsNotAboveZero)
{
  vtkNew<ErrorObserver> tableErrors;
  Scene.Table->AddObserver(vtkCommand::ErrorEvent, tableErrors);
  Scene.Table->SetRange(0.5, 1.5);
  Scene.Table->SetScaleToLog10();
  Render();
  EXPECT_NE(Warnings->Text.find("logarithmic"), std::string::npos) << Warnings->Text;
  EXPECT_NE(Warnings->Text.find("-1 to 2"), std::string::npos) << Warnings->Text;
  // The mapper reports the problem, so the table reports no error.
  EXPECT_EQ(tableErrors->Text, "");
  EXPECT_EQ(Scene.Table->GetRange()[0], 0.5);
  Scene.Mapper->SetRangeModeToCut();
  Render();
  // The range covers the values that have a logarithm.
  EXPECT_EQ(Warnings->Text, "");
  EXPECT_GT(Scene.Mapper->GetScalarRange()[0], 0.0);
  EXPECT_EQ(Scene.Table->GetRange()[0], Scene.Mapper->GetScalarRange()[0]);
  Scene.Mapper->SetScalarRange(0.1, 2.0);
  Render();
  EXPECT_EQ(Warnings->Text, "");
  EXPECT_EQ(Scene.Table->GetRange()[0], 0.1);
  EXPECT_EQ(tableErrors->Text, "");
}

TEST_F(StockSettings, RangesThatAreNoneAreRefused)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kHuge = std::numeric_limits<double>::max();
  const auto expect = [&](bool refused, const char* text)
  {
    Render();
    EXPECT_EQ(Errors->Text.find(text) != std::string::npos, refused) << Errors->Text;
    EXPECT_EQ(Scene.Mapper->GetBuffers() == nullptr, refused);
  };
  vtkNew<ErrorObserver> tableErrors;
  Scene.Table->AddObserver(vtkCommand::ErrorEvent, tableErrors);
  for (const auto& [lower, upper] : std::initializer_list<std::pair<double, double>>{
         { 0.5, -0.5 }, { kNan, 1.0 }, { 0.0, kNan }, { 0.0, kInfinity }, { -kHuge, kHuge } })
  {
    Scene.Mapper->SetScalarRange(lower, upper);
    expect(true, "range of colours");
  }
  EXPECT_EQ(tableErrors->Text, "");
  // No colours are requested then.
  Scene.Mapper->ScalarVisibilityOff();
  expect(false, "range");
  Scene.Mapper->ScalarVisibilityOn();
  Scene.Mapper->SetScalarRange(0.5, 0.5);
  expect(false, "range");
  Scene.Mapper->UseLookupTableScalarRangeOn();
  Scene.Table->SetRange(kNan, 1.0);
  expect(true, "range of colours");
}

TEST_F(StockSettings, TablesWithoutColorsAreRefused)
{
  vtkNew<vtkColorTransferFunction> function;
  Scene.Mapper->SetLookupTable(function);
  Render();
  EXPECT_NE(Errors->Text.find("has no colours"), std::string::npos) << Errors->Text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
  function->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  Render();
  EXPECT_EQ(Errors->Text, "");
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(0);
  Scene.Mapper->SetLookupTable(table);
  Render();
  EXPECT_NE(Errors->Text.find("has no colours"), std::string::npos) << Errors->Text;
}

TEST_F(StockSettings, RangeOfTheField)
{
  vtkNew<vtkHighOrderMapper> fresh;
  EXPECT_EQ(fresh->GetRangeMode(), vtkHighOrderMapper::RANGE_OF_FIELD);
  // Whoever sets a range gets it.
  EXPECT_EQ(Scene.Mapper->GetRangeMode(), vtkHighOrderMapper::RANGE_AS_SET);
  ExpectRange(CutScene::kRange[0], CutScene::kRange[1], 0.0);
  Scene.Mapper->SetRangeModeToField();
  // u = x^3 - x/2 + y^2 + z/4 in the cube; the proven range holds the ends, which are attained.
  ExpectRange(-0.75, 1.75, 0.0025);
  EXPECT_LE(Scene.Table->GetRange()[0], -0.75);
  EXPECT_GE(Scene.Table->GetRange()[1], 1.75);
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 1);
  // v = (x + y, y z, 1 - z).
  Scene.Mapper->SetFieldName("v");
  Scene.Mapper->SetArrayComponent(2);
  ExpectRange(0.0, 2.0, 0.002);
  Scene.Mapper->SetArrayComponent(-1);
  Scene.Table->SetVectorModeToMagnitude();
  ExpectRange(0.0, 3.0, 0.003);
  // Elements without finite values are left out: the others are 1.
  Scene.Mapper->SetFieldName("nan");
  ExpectRange(1.0, 1.0, 1e-12);
  // The range of all that the table colours.
  Scene.Mapper->SetFieldName("u");
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.5);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(sphere);
  layer->SetFieldName("v");
  layer->SetComponent(2);
  Scene.Mapper->AddLayer(layer);
  ExpectRange(-0.75, 2.0, 0.003);
  // The magnitude of a scalar is its value.
  layer->SetFieldName("u");
  layer->SetComponent(vtkHighOrderLayer::MAGNITUDE);
  ExpectRange(-0.75, 1.75, 0.0025);
  vtkNew<vtkLookupTable> own;
  layer->SetLookupTable(own);
  ExpectRange(-0.75, 1.75, 0.0025);
  EXPECT_EQ(own->GetRange()[1], 1.0);
  Scene.Table->SetRange(3.0, 4.0);
  Scene.Mapper->UseLookupTableScalarRangeOn();
  ExpectRange(3.0, 4.0, 0.0);

  vtkNew<vtkHighOrderMapper> copy;
  copy->ShallowCopy(Scene.Mapper);
  EXPECT_EQ(copy->GetRangeMode(), vtkHighOrderMapper::RANGE_OF_FIELD);
}

TEST_F(StockSettings, RangeOfTheCut)
{
  Scene.Mapper->SetRangeModeToCut();
  Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfTraces(), 1);
  EXPECT_EQ(Scene.Mapper->GetNumberOfColorings(), 1);
  const auto expectShown = [&]
  {
    Render();
    vtkDataArray* value = Scene.Mapper->GetBuffers()->GetPointData()->GetArray("Value");
    double lower = 1e30;
    double upper = -1e30;
    for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
    {
      const double v = value->GetTuple1(i);
      lower = v < lower ? v : lower;
      upper = v > upper ? v : upper;
    }
    ExpectRange(lower, upper, 0.0);
    EXPECT_EQ(Scene.Mapper->GetSeenRange()[0], lower);
    EXPECT_EQ(Scene.Mapper->GetSeenRange()[1], upper);
  };
  expectShown();
  // The range at z = 0; pixels come close to its ends.
  ExpectRange(-0.5, 1.5, 0.05);
  const vtkIdType colorings = Scene.Mapper->GetNumberOfColorings();
  Render();
  EXPECT_EQ(Scene.Mapper->GetNumberOfColorings(), colorings);
  Scene.Function->SetOrigin(0.0, 0.0, 0.8);
  expectShown();
  ExpectRange(-0.3, 1.7, 0.05);
  // Nothing is seen: the range stays.
  Scene.Function->SetOrigin(0.0, 0.0, 5.0);
  ExpectRange(-0.3, 1.7, 0.05);
  Render();
  EXPECT_EQ(Scene.Mapper->GetSeenRange()[0], 1.0);
  EXPECT_EQ(Scene.Mapper->GetSeenRange()[1], -1.0);
}
} // namespace pixelexact
