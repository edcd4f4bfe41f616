// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Trace/Scene.h"
#include "Views/VtkColorMap.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <limits>

namespace pixelexact
{
namespace
{
/// Values around and across the range [0.1, 10], and those that are special.
std::vector<double> Values()
{
  std::vector<double> values{ std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0, -0.0,
    -3.0, 0.1, 10.0, 1e300, -1e300, std::nextafter(0.1, 0.0), std::nextafter(10.0, 11.0) };
  for (int i = 0; i < 5000; ++i)
  {
    values.push_back(-1.0 + 0.003 * i);
  }
  return values;
}

/// Ours, in chunks from several threads, is what VTK makes of the same values as an array; where
/// scales are logarithmic, of NaN in the place of values that are not above 0.
void ExpectVtksColors(vtkScalarsToColors* table)
{
  const std::vector<double> values = Values();
  const ColorMap map = ToColorMap(table);
  std::vector<std::uint8_t> ours(4 * values.size());
  constexpr std::size_t kChunk = 7;
  tbb::parallel_for(std::size_t{ 0 }, (values.size() + kChunk - 1) / kChunk,
    [&](std::size_t i)
    {
      const std::size_t begin = i * kChunk;
      const std::size_t count = std::min(kChunk, values.size() - begin);
      map(std::span(values).subspan(begin, count), ours.data() + 4 * begin);
    });
  vtkNew<vtkDoubleArray> array;
  for (const double value : values)
  {
    const bool hasColor = table->UsingLogScale() == 0 || value > 0.0;
    array->InsertNextValue(hasColor ? value : std::numeric_limits<double>::quiet_NaN());
  }
  const auto vtk = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(array, VTK_COLOR_MODE_MAP_SCALARS, 0));
  ASSERT_EQ(vtk->GetNumberOfComponents(), 4);
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    ASSERT_EQ(ours[i], vtk->GetValue(static_cast<vtkIdType>(i)))
      << "value " << values[i / 4] << ", channel " << i % 4;
  }
}
} // namespace

TEST(VtkColorMap, LookupTable)
{
  vtkNew<vtkLookupTable> table;
  table->SetRange(0.1, 10.0);
  table->SetNanColor(0.1, 0.2, 0.3, 0.4);
  ExpectVtksColors(table);
  table->SetBelowRangeColor(1.0, 1.0, 1.0, 0.5);
  table->UseBelowRangeColorOn();
  table->SetAboveRangeColor(0.0, 0.0, 0.0, 1.0);
  table->UseAboveRangeColorOn();
  ExpectVtksColors(table);
  table->SetScaleToLog10();
  ExpectVtksColors(table);
  table->SetAlpha(0.5);
  ExpectVtksColors(table);
}

TEST(VtkColorMap, ColorTransferFunction)
{
  vtkNew<vtkColorTransferFunction> table;
  table->AddRGBPoint(0.1, 1.0, 0.0, 0.0);
  table->AddRGBPoint(2.0, 0.3, 0.7, 0.1, 0.2, 0.4);
  table->AddRGBPoint(10.0, 0.0, 0.0, 1.0);
  table->SetNanColor(0.0, 1.0, 0.0);
  ExpectVtksColors(table);
  table->SetBelowRangeColor(1.0, 1.0, 1.0);
  table->UseBelowRangeColorOn();
  table->SetAboveRangeColor(0.5, 0.5, 0.0);
  table->UseAboveRangeColorOn();
  ExpectVtksColors(table);
  table->SetScaleToLog10();
  ExpectVtksColors(table);
  table->ClampingOff();
  ExpectVtksColors(table);
}

TEST(VtkColorMap, DiscretizableColorTransferFunction)
{
  vtkNew<vtkDiscretizableColorTransferFunction> table;
  table->AddRGBPoint(0.1, 1.0, 0.0, 0.0);
  table->AddRGBPoint(10.0, 0.0, 0.0, 1.0);
  ExpectVtksColors(table);
  table->SetNumberOfValues(7);
  table->DiscretizeOn();
  ExpectVtksColors(table);
  table->SetUseLogScale(1);
  ExpectVtksColors(table);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.1, 0.0);
  opacity->AddPoint(10.0, 1.0);
  table->SetScalarOpacityFunction(opacity);
  table->EnableOpacityMappingOn();
  ExpectVtksColors(table);
}

TEST(VtkColorMap, NamedMapsSpanTheRange)
{
  for (const std::string& name : ColorMapNames())
  {
    SCOPED_TRACE(name);
    const auto table = MakeColorMap(name, { -2.0, 5.0 });
    EXPECT_EQ(table->GetRange()[0], -2.0);
    EXPECT_EQ(table->GetRange()[1], 5.0);
    ExpectVtksColors(table);
    // Values outside the range have the colours of its ends.
    const double values[] = { -2.0, -1e9, 5.0, 1e9 };
    std::array<std::uint8_t, 16> colors{};
    ToColorMap(table)(values, colors.data());
    EXPECT_TRUE(std::equal(colors.begin(), colors.begin() + 4, colors.begin() + 4));
    EXPECT_TRUE(std::equal(colors.begin() + 8, colors.begin() + 12, colors.begin() + 12));
  }
  const double ends[] = { 0.0, 1.0 };
  std::array<std::uint8_t, 8> colors{};
  ToColorMap(MakeColorMap("viridis", { 0.0, 1.0 }))(ends, colors.data());
  EXPECT_EQ(colors, (std::array<std::uint8_t, 8>{ 0x44, 0x01, 0x54, 255, 0xfd, 0xe7, 0x25, 255 }));
}

TEST(VtkColorMap, ReversedMapsRunFromTheLastColorToTheFirst)
{
  for (const std::string& name : ColorMapNames())
  {
    SCOPED_TRACE(name);
    const auto table = MakeColorMap(name, { 0.0, 1.0 });
    const auto other = MakeColorMap(name + "_r", { 0.0, 1.0 });
    const vtkIdType last = table->GetNumberOfTableValues() - 1;
    for (vtkIdType i = 0; i <= last; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        ASSERT_NEAR(table->GetTableValue(i)[c], other->GetTableValue(last - i)[c], 1e-9) << i;
      }
    }
  }
}

TEST(VtkColorMap, NamesAreThoseOfTheTable)
{
  for (const std::string& name : ColorMapNames())
  {
    EXPECT_TRUE(HasColorMap(name));
    EXPECT_TRUE(HasColorMap(name + "_r"));
    EXPECT_FALSE(HasColorMap(name + "_r_r"));
  }
  EXPECT_FALSE(HasColorMap("virids"));
  EXPECT_FALSE(HasColorMap("_r"));
  EXPECT_FALSE(HasColorMap(""));
}

TEST(VtkColorMap, ConstantFieldsHaveAColor)
{
  for (const double value : { 0.0, 3.5, -1e30, 1e-320 })
  {
    const auto table = MakeColorMap("grayscale", { value, value });
    std::array<std::uint8_t, 4> color{};
    ToColorMap(table)(std::span(&value, 1), color.data());
    EXPECT_NEAR(color[0], 127, 1) << value;
  }
}

TEST(VtkColorMap, NonsenseIsRefused)
{
  try
  {
    (void)MakeColorMap("virids", { 0.0, 1.0 });
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("viridis"), std::string::npos);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)MakeColorMap("jet", { 1.0, 0.0 }), Error);
  EXPECT_THROW((void)MakeColorMap("jet", { 0.0, infinity }), Error);
  EXPECT_THROW((void)ToColorMap(nullptr), Error);
}

TEST(VtkColorMap, ComponentsAreTheTables)
{
  vtkNew<vtkLookupTable> table;
  EXPECT_EQ(ComponentOf(nullptr, 3), 0);
  EXPECT_EQ(ComponentOf(table, 3), 0);
  table->SetVectorComponent(2);
  EXPECT_EQ(ComponentOf(table, 3), 2);
  EXPECT_EQ(ComponentOf(table, 1), 0);
  EXPECT_THROW((void)ComponentOf(table, 2), Error);
  table->SetVectorModeToMagnitude();
  EXPECT_EQ(ComponentOf(table, 3), kMagnitude);
  EXPECT_EQ(ComponentOf(table, 1), 0);
  table->SetVectorModeToRGBColors();
  EXPECT_THROW((void)ToColorMap(table), Unsupported);
}
} // namespace pixelexact
