// SPDX-License-Identifier: BSD-3-Clause
#include "Support.h"

#include "HighOrderModel.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// A Lagrange hexahedron of order n whose nodes are map(r, s, t).
vtkSmartPointer<vtkUnstructuredGrid> LagrangeHexahedron(
  int n, const std::function<Vec3(double, double, double)>& map, int pointType = VTK_DOUBLE)
{
  const auto grid =
    OneCell(VTK_LAGRANGE_HEXAHEDRON, std::vector<double>(3 * (n + 1) * (n + 1) * (n + 1)));
  const double* rst = grid->GetCell(0)->GetParametricCoords();
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Vec3 x = map(rst[3 * i], rst[3 * i + 1], rst[3 * i + 2]);
    points->InsertNextPoint(x.x, x.y, x.z);
  }
  grid->SetPoints(points);
  return grid;
}

std::array<int, 3> GeometryOrders(vtkUnstructuredGrid* grid)
{
  const auto model = HighOrderModel::From(Converted(grid));
  const auto& order = model->GetMesh().map.SpaceOf(0).order;
  return { order[0], order[1], order[2] };
}

Vec3 Cubic(double r, double s, double t)
{
  return { r + 0.1 * s * s * s, s + 0.2 * r * t * t, t - 0.1 * r * r * s };
}

TEST(Conversion, ReducesTheGeometryAlone)
{
  const auto grid = LagrangeHexahedron(6, Cubic);
  AddPointField(grid, "u", std::vector<double>(grid->GetNumberOfPoints(), 1.0));
  const auto output = Converted(grid);
  int range[2];
  output->GetGeometryOrderRange(range);
  EXPECT_EQ(range[0], 2);
  EXPECT_EQ(range[1], 3);
  output->GetFieldOrderRange("u", range);
  EXPECT_EQ(range[0], 6);
  EXPECT_EQ(range[1], 6);
  EXPECT_EQ(GeometryOrders(grid), (std::array{ 2, 3, 2 }));
}

TEST(Conversion, KeepsSmallHighOrders)
{
  // A mode of 1e-11 is no rounding.
  const auto grid = LagrangeHexahedron(
    5, [](double r, double s, double t) { return Vec3(r + 1e-11 * std::pow(s, 5), s, t); });
  EXPECT_EQ(GeometryOrders(grid), (std::array{ 1, 5, 1 }));
}

TEST(Conversion, ReducesFarFromTheOrigin)
{
  // Coordinates of 1e8 + [0,1]: rounded to 1.5e-8, and all of that is noise.
  const auto grid = LagrangeHexahedron(
    4, [](double r, double s, double t) { return 1e8 + Vec3(r + 0.3 * s * t, s, t); });
  EXPECT_EQ(GeometryOrders(grid), (std::array{ 1, 1, 1 }));
}

TEST(Conversion, ReducesFloatCoordinates)
{
  EXPECT_EQ(GeometryOrders(LagrangeHexahedron(4, Cubic, VTK_FLOAT)), (std::array{ 2, 3, 2 }));
}

TEST(Conversion, UncertaintyCoversTheLoss)
{
  for (const double offset : { 0.0, 1e3, 1e6 })
  {
    const auto map = [&](double r, double s, double t) { return offset + Cubic(r, s, t); };
    const auto output = Converted(LagrangeHexahedron(6, map));
    const auto model = HighOrderModel::From(output);
    const double uncertainty = model->GetMesh().uncertainty[0];
    EXPECT_LE(uncertainty, 1e-12 * (1.0 + offset));
    for (double r = 0.05; r < 1.0; r += 0.1)
    {
      const double xi[3] = { 2 * r - 1, 1 - 2 * r * r, std::sin(9 * r) };
      double x[3];
      ASSERT_TRUE(output->MapForward(0, xi, x));
      const Vec3 y = Cubic((1 + xi[0]) / 2, (1 + xi[1]) / 2, (1 + xi[2]) / 2);
      for (int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(x[d] - offset, y[d], uncertainty + 1e-15);
      }
    }
  }
}

TEST(Conversion, SizesFromTinyToHuge)
{
  for (const double scale : { 1e-200, 1e-12, 1.0, 1e12, 1e200 })
  {
    const auto output = Converted(
      LagrangeHexahedron(3, [&](double r, double s, double t) { return scale * Cubic(r, s, t); }));
    const auto model = HighOrderModel::From(output);
    const double size = model->GetMesh().size[0];
    int exponent = 0;
    EXPECT_EQ(std::frexp(size, &exponent), 0.5);
    EXPECT_GE(size, 0.45 * scale);
    EXPECT_LE(size, 2.5 * scale);
    const double xi[3] = { 1, 1, 1 };
    double x[3];
    ASSERT_TRUE(output->MapForward(0, xi, x));
    EXPECT_NEAR(x[0] / scale, 1.1, 1e-14);
  }
}

TEST(Conversion, LeavesOutLowerDimensions)
{
  const auto grid = Boxes(1);
  const vtkIdType quad[4] = { 0, 1, 3, 2 };
  const vtkIdType line[2] = { 0, 1 };
  const vtkIdType box[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  vtkNew<vtkUnstructuredGrid> mixed;
  mixed->SetPoints(grid->GetPoints());
  mixed->GetPointData()->ShallowCopy(grid->GetPointData());
  mixed->Allocate(4);
  mixed->InsertNextCell(VTK_QUAD, 4, quad);
  mixed->InsertNextCell(VTK_LINE, 2, line);
  mixed->InsertNextCell(VTK_EMPTY_CELL, 0, static_cast<const vtkIdType*>(nullptr));
  mixed->InsertNextCell(VTK_HEXAHEDRON, 8, box);
  vtkNew<vtkIntArray> material;
  material->SetName("material");
  for (int i = 0; i < 4; ++i)
  {
    material->InsertNextValue(10 + i);
  }
  mixed->GetCellData()->AddArray(material);
  Conversion conversion(mixed);
  ASSERT_TRUE(conversion.done) << conversion.messages->errors;
  EXPECT_EQ(conversion.filter->GetNumberOfSkippedCells(), 3);
  EXPECT_EQ(conversion.Output()->GetNumberOfCells(), 1);
  EXPECT_EQ(HighOrderModel::From(conversion.Output())->SourceCells()[0], 3);
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0.3, 0.1, 0.0 };
  ASSERT_TRUE(conversion.Output()->EvaluateField("material", 0, xi, value));
  EXPECT_EQ(value->GetValue(0), 13.0);
}

TEST(Conversion, ChoosesFields)
{
  const auto grid = Boxes(1);
  AddPointField(grid, "g", std::vector<double>(8, 2.0));
  AddPointField(grid, "vtkOriginalPointIds", std::vector<double>(8, 2.0));
  EXPECT_EQ(Converted(grid)->GetNumberOfHighOrderFields(), 2);
  vtkNew<vtkUnstructuredGridToHighOrderGrid> filter;
  filter->SetInputData(grid);
  filter->AddField("g");
  filter->Update();
  ASSERT_EQ(filter->GetHighOrderOutput()->GetNumberOfHighOrderFields(), 1);
  EXPECT_EQ(filter->GetHighOrderOutput()->GetHighOrderFieldName(0), "g");
  filter->ClearFields();
  filter->Update();
  EXPECT_EQ(filter->GetHighOrderOutput()->GetNumberOfHighOrderFields(), 2);
}

TEST(Conversion, KeepsVectors)
{
  const auto grid = Boxes(1);
  vtkNew<vtkDoubleArray> v;
  v->SetName("v");
  v->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    v->InsertNextTuple3(x[1], x[2] * x[0], 5.0);
  }
  grid->GetPointData()->AddArray(v);
  const auto output = Converted(grid);
  EXPECT_EQ(output->GetHighOrderFieldComponents("v"), 3);
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0.5, 0.0, -0.5 }; // (0.75, 0.5, 0.25)
  ASSERT_TRUE(output->EvaluateField("v", 0, xi, value));
  EXPECT_DOUBLE_EQ(value->GetComponent(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(value->GetComponent(0, 1), 0.25 * 0.75);
  EXPECT_DOUBLE_EQ(value->GetComponent(0, 2), 5.0);
}

TEST(Conversion, IsRepeatable)
{
  const auto once = Converted(Boxes(2));
  const auto twice = Converted(once);
  EXPECT_EQ(twice->GetNumberOfHighOrderFields(), once->GetNumberOfHighOrderFields());
  EXPECT_EQ(twice->GetFieldData()->GetNumberOfArrays(), once->GetFieldData()->GetNumberOfArrays());
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(twice), "");
}
} // namespace
