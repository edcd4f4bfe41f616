// SPDX-License-Identifier: BSD-3-Clause
#include "Support.h"

#include "vtkContourFilter.h"
#include "vtkCutter.h"
#include "vtkHighOrderLinearResample.h"
#include "vtkHighOrderProbe.h"
#include "vtkImageData.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

TEST(Probe, AnswersInsideAndOutside)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.3, 0.6, 0.9);
  points->InsertNextPoint(1.5, 0.5, 0.5);
  points->InsertNextPoint(0.0, 0.0, 0.0); // a corner
  points->InsertNextPoint(std::nan(""), 0.0, 0.0);
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(where);
  probe->SetSourceData(Boxes(2)); // a plain grid is converted
  probe->ComputeGradientsOn();
  probe->Update();
  auto* output = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  vtkPointData* data = output->GetPointData();
  const auto get = [&](const char* name, vtkIdType i, int c = 0)
  { return data->GetArray(name)->GetComponent(i, c); };
  EXPECT_NEAR(get("f", 0), 0.3 + 1.2 + 2.7, 1e-14);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(get("f_Gradient", 0, d), 1.0 + d, 1e-13);
  }
  EXPECT_EQ(get("Verdict", 0), 1.0);
  EXPECT_EQ(get("Element", 0), 6.0);
  EXPECT_NEAR(get("Xi", 0, 0), 0.2, 1e-14);
  EXPECT_LE(get("Residual", 0), 1e-14);
  for (const vtkIdType outside : { 1, 3 })
  {
    EXPECT_EQ(get("Verdict", outside), 0.0);
    EXPECT_EQ(get("Element", outside), -1.0);
    EXPECT_TRUE(std::isnan(get("f", outside)));
    EXPECT_TRUE(std::isnan(get("Xi", outside)));
  }
  EXPECT_EQ(get("Verdict", 2), 1.0);
  EXPECT_NEAR(get("f", 2), 0.0, 1e-15);
}

TEST(Probe, KeepsTheTypeOfThePoints)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 5);
  image->SetSpacing(0.4, 0.3, 0.2);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(image);
  probe->SetSourceData(Converted(Boxes(2)));
  probe->Update();
  auto* output = vtkImageData::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("f")->GetNumberOfTuples(), 60);
  EXPECT_EQ(output->GetPointData()->GetArray("f_Gradient"), nullptr);
}

TEST(Probe, TakesMovedPoints)
{
  const auto grid = Converted(Boxes(2));
  grid->GetPoints()->SetPoint(0, -0.1, 0.0, 0.0);
  grid->GetPoints()->Modified();
  vtkNew<vtkHighOrderProbe> probe;
  vtkNew<Messages> messages;
  messages->Watch(probe);
  vtkNew<vtkPolyData> where;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.05, 0.0, 0.0); // outside before
  where->SetPoints(points);
  probe->SetInputData(where);
  probe->SetSourceData(grid);
  probe->Update();
  EXPECT_EQ(messages->errors, "");
  vtkPointData* data = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  EXPECT_EQ(data->GetArray("Element")->GetComponent(0, 0), 0.0);
}

TEST(Probe, RefusesAFieldOfTheNameOfItsOwnArrays)
{
  const auto grid = Boxes(2);
  grid->GetPointData()->GetArray("f")->SetName("Element");
  vtkNew<vtkHighOrderProbe> probe;
  vtkNew<Messages> messages;
  messages->Watch(probe);
  vtkNew<vtkPolyData> where;
  probe->SetInputData(where);
  probe->SetSourceData(grid);
  probe->Update();
  EXPECT_NE(messages->errors.find("'Element'"), std::string::npos) << messages->errors;
}

TEST(LinearResample, IsExactAtNodes)
{
  vtkNew<vtkHighOrderLinearResample> resample;
  resample->SetInputData(Converted(Boxes(2)));
  resample->SetDimensions(5, 6, 7);
  resample->SetSamplingBounds(0.0, 1.0, 0.1, 0.9, -0.5, 0.5);
  resample->Update();
  vtkImageData* image = resample->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), 5 * 6 * 7);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const bool inside = x[2] >= 0.0;
    const double f = image->GetPointData()->GetArray("f")->GetComponent(i, 0);
    EXPECT_EQ(
      image->GetPointData()->GetArray("vtkValidPointMask")->GetComponent(i, 0), inside ? 1 : 0);
    if (inside)
    {
      EXPECT_NEAR(f, x[0] + 2 * x[1] + 3 * x[2], 1e-14);
    }
    else
    {
      EXPECT_TRUE(std::isnan(f));
    }
  }
}

TEST(LinearResample, FeedsStockFilters)
{
  vtkNew<vtkHighOrderLinearResample> resample;
  resample->SetInputData(Converted(Boxes(2)));
  resample->SetDimensions(9, 9, 9);
  resample->SetSamplingBounds(-0.5, 1.5, -0.5, 1.5, -0.5, 1.5);
  resample->Update();
  resample->GetOutput()->GetPointData()->SetActiveScalars("f");

  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(resample->GetOutput());
  contour->SetValue(0, 3.0);
  contour->Update();
  vtkPolyData* surface = contour->GetOutput();
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    EXPECT_NEAR(x[0] + 2 * x[1] + 3 * x[2], 3.0, 1e-5); // float points
  }

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.4, 0.4, 0.4);
  vtkNew<vtkCutter> cutter;
  cutter->SetCutFunction(plane);
  cutter->SetInputData(resample->GetOutput());
  cutter->Update();
  ASSERT_GT(cutter->GetOutput()->GetNumberOfCells(), 0);
  double range[2];
  cutter->GetOutput()->GetPointData()->GetArray("f")->GetRange(range);
  EXPECT_TRUE(std::isfinite(range[0]) && std::isfinite(range[1]));
}

TEST(LinearResample, TakesTheGridsBoxByDefault)
{
  vtkNew<vtkHighOrderLinearResample> resample;
  resample->SetInputData(Boxes(2));
  resample->SetDimensions(3, 1, 2);
  resample->Update();
  double bounds[6];
  resample->GetOutput()->GetBounds(bounds);
  EXPECT_DOUBLE_EQ(bounds[0], 0.0);
  EXPECT_DOUBLE_EQ(bounds[1], 1.0);
  EXPECT_DOUBLE_EQ(bounds[2], 0.5);
  double range[2];
  resample->GetOutput()->GetPointData()->GetArray("f")->GetRange(range);
  EXPECT_NEAR(range[0], 1.0, 1e-14);
  EXPECT_NEAR(range[1], 5.0, 1e-14);
}
} // namespace
