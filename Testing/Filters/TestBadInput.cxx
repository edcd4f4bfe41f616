// SPDX-License-Identifier: BSD-3-Clause
// What users get wrong, or files: each message names the thing and a remedy.
#include "LongVectors.h"
#include "Support.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkHighOrderProbe.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

void ExpectRefused(vtkUnstructuredGrid* grid, std::initializer_list<const char*> words)
{
  Conversion conversion(grid);
  EXPECT_FALSE(conversion.done);
  for (const char* word : words)
  {
    EXPECT_NE(conversion.messages->errors.find(word), std::string::npos)
      << conversion.messages->errors;
  }
  EXPECT_EQ(conversion.Output()->GetNumberOfCells(), 0);
}

std::vector<double> Nodes(int points)
{
  std::vector<double> xyz(3 * points);
  for (std::size_t i = 0; i < xyz.size(); ++i)
  {
    xyz[i] = std::sin(1.0 + 7.0 * i);
  }
  return xyz;
}

TEST(BadInput, EmptyGrid)
{
  vtkNew<vtkUnstructuredGrid> grid;
  ExpectRefused(grid, { "no two- or three-dimensional cell" });
}

TEST(BadInput, OnlyLines)
{
  ExpectRefused(OneCell(VTK_LINE, Nodes(2)), { "no two- or three-dimensional cell", "1 of other" });
}

TEST(BadInput, SurfacesWithoutArea)
{
  ExpectRefused(OneCell(VTK_TRIANGLE, { 0, 0, 0, 1, 0, 1, 2, 0, 2 }), { "cell 0", "has no area" });
}

TEST(BadInput, PlaneCellsThatAreNoPolynomials)
{
  auto points = Nodes(5);
  for (std::size_t i = 2; i < points.size(); i += 3)
  {
    points[i] = 0.0;
  }
  ExpectRefused(OneCell(VTK_POLYGON, points), { "cell 0", "vtkPolygon", "not supported" });
}

TEST(BadInput, UnsupportedTypes)
{
  const auto grid = Boxes(1);
  grid->GetPoints()->InsertNextPoint(0.5, 0.5, 2.0);
  grid->GetPointData()->Initialize();
  const vtkIdType ids[5] = { 4, 5, 6, 7, 8 };
  grid->InsertNextCell(VTK_LAGRANGE_PYRAMID, 5, ids);
  ExpectRefused(grid, { "cell 1", "VTK_LAGRANGE_PYRAMID", "not supported" });
  ExpectRefused(OneCell(VTK_PENTAGONAL_PRISM, Nodes(10)), { "cell 0", "vtkPentagonalPrism" });
  ExpectRefused(OneCell(VTK_CONVEX_POINT_SET, Nodes(5)), { "vtkConvexPointSet" });
  ExpectRefused(OneCell(VTK_HIGHER_ORDER_HEXAHEDRON, Nodes(8)), { "cell type 67" });
}

TEST(BadInput, WrongNumberOfPoints)
{
  ExpectRefused(OneCell(VTK_LAGRANGE_HEXAHEDRON, Nodes(12)),
    { "cell 0", "vtkLagrangeHexahedron", "12 points", "HigherOrderDegrees" });
  ExpectRefused(OneCell(VTK_LAGRANGE_TETRAHEDRON, Nodes(11)), { "11 points" });
  const auto grid = OneCell(VTK_LAGRANGE_WEDGE, Nodes(18));
  vtkNew<vtkIntArray> degrees;
  degrees->SetNumberOfComponents(3);
  degrees->SetName("HigherOrderDegrees");
  const int given[3] = { 2, 2, 3 };
  degrees->InsertNextTypedTuple(given);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  ExpectRefused(grid, { "cell 0", "contradicts", "2, 2, 3" });

  vtkNew<vtkDoubleArray> children; // cut to integers they would fit
  children->SetNumberOfComponents(3);
  children->SetName("HigherOrderDegrees");
  children->InsertNextTuple3(2.5, 2.5, 2.5);
  grid->GetCellData()->SetHigherOrderDegrees(children);
  ExpectRefused(grid, { "cell 0", "HigherOrderDegrees of 2.5" });
}

TEST(BadInput, RationalBezier)
{
  auto grid = OneCell(VTK_BEZIER_TETRAHEDRON, Nodes(10));
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("RationalWeights");
  weights->SetNumberOfValues(10);
  weights->FillValue(0.5);
  grid->GetPointData()->SetRationalWeights(weights);
  EXPECT_TRUE(Conversion(grid).done);
  for (const double bad : { 0.0, -0.5, kNaN })
  {
    weights->SetValue(3, bad);
    weights->Modified();
    ExpectRefused(grid, { "cell 0", "vtkBezierTetra", "weights must be positive" });
  }
}

TEST(BadInput, CoordinatesThatAreNoNumbers)
{
  for (const double bad : { kNaN, std::numeric_limits<double>::infinity() })
  {
    const auto grid = Boxes(2);
    grid->GetPoints()->SetPoint(13, 0.5, bad, 0.5); // shared by all eight
    ExpectRefused(grid, { "cell 0", "7 more", "NaN" });
    grid->GetPoints()->SetPoint(13, 0.5, 0.5, 0.5);
    grid->GetPoints()->SetPoint(26, bad, 1.0, 1.0);
    ExpectRefused(grid, { "cell 7" });
  }
  ExpectRefused(OneCell(VTK_TETRA, { 0, 0, 0, 1.7e308, 0, 0, 0, 1.7e308, 0, -1.7e308, 0, 1.7e308 }),
    { "cell 0", "too large" });
}

TEST(BadInput, ValuesThatAreNoNumbers)
{
  const auto grid = Boxes(2);
  grid->GetPointData()->GetArray("f")->SetComponent(0, 0, kNaN);
  Conversion conversion(grid);
  ASSERT_TRUE(conversion.done);
  EXPECT_EQ(conversion.filter->GetNumberOfNonFiniteElements("f"), 1);
  EXPECT_EQ(conversion.filter->GetNumberOfNonFiniteElements("g"), 0);
  EXPECT_NE(
    conversion.messages->warnings.find("'f' is NaN or infinite in 1 of 8"), std::string::npos);
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(conversion.Output()), "");
  vtkNew<vtkDoubleArray> value;
  const double xi[3] = { 0, 0, 0 };
  ASSERT_TRUE(conversion.Output()->EvaluateField("f", 0, xi, value));
  EXPECT_TRUE(std::isnan(value->GetValue(0)));
  ASSERT_TRUE(conversion.Output()->EvaluateField("f", 7, xi, value));
  EXPECT_DOUBLE_EQ(value->GetValue(0), 0.75 * 6);
}

TEST(BadInput, FieldThatIsNotThere)
{
  const auto grid = Boxes(1);
  vtkNew<vtkUnstructuredGridToHighOrderGrid> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(grid);
  filter->AddField("g");
  filter->Update();
  EXPECT_NE(messages->errors.find("'g'"), std::string::npos) << messages->errors;
  EXPECT_NE(messages->errors.find("f"), std::string::npos);

  const auto output = Converted(grid);
  vtkNew<Messages> own;
  own->Watch(output);
  const double xi[3] = { 0, 0, 0 };
  double x[3];
  vtkNew<vtkDoubleArray> value;
  EXPECT_FALSE(output->EvaluateField("g", 0, xi, value));
  EXPECT_NE(own->errors.find("'g'"), std::string::npos);
  EXPECT_FALSE(output->MapForward(1, xi, x));
  EXPECT_NE(own->errors.find("element 1"), std::string::npos);
  EXPECT_FALSE(output->MapForward(-1, xi, x));

  vtkNew<vtkHighOrderProbe> probe;
  vtkNew<Messages> probed;
  probed->Watch(probe);
  vtkNew<vtkPolyData> points;
  probe->SetInputData(points);
  probe->SetSourceData(output);
  probe->AddField("g");
  probe->Update();
  EXPECT_NE(probed->errors.find("'g'"), std::string::npos);
}

TEST(BadInput, DegenerateElements)
{
  // Flat, and shrunk to a point: no error, no infinity, a warning.
  for (const double scale : { 1.0, 0.0 })
  {
    Conversion conversion(
      OneCell(VTK_TETRA, { 5, 0, 0, 5 + scale, 0, 0, 5, scale, 0, 5 + scale, scale, 0 }));
    ASSERT_TRUE(conversion.done) << conversion.messages->errors;
    EXPECT_EQ(conversion.filter->GetNumberOfDiagnostics(), 1);
    const double xi[3] = { -1, -1, -1 };
    double x[3];
    ASSERT_TRUE(conversion.Output()->MapForward(0, xi, x));
    EXPECT_DOUBLE_EQ(x[0], 5.0);
  }
}

class DamagedArrays : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkHighOrderGrid> Grid = Converted(Boxes(2));

  void ExpectInvalid(const std::string& word)
  {
    Grid->Modified();
    const std::string problem = vtkHighOrderGrid::CheckCoefficients(Grid);
    EXPECT_NE(problem.find(word), std::string::npos) << problem;
    EXPECT_THROW(HighOrderModel::From(Grid), Error);
  }
};

TEST_F(DamagedArrays, Missing)
{
  std::vector<std::string> names;
  for (int i = 0; i < Grid->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(Grid->GetFieldData()->GetArrayName(i));
  }
  EXPECT_EQ(names.size(), 10U + 7U);
  for (const auto& name : names)
  {
    if (name.ends_with("Coefficients"))
    {
      continue; // without them there is no mesh or no field
    }
    vtkSmartPointer<vtkDataArray> array = Grid->GetFieldData()->GetArray(name.c_str());
    Grid->GetFieldData()->RemoveArray(name.c_str());
    ExpectInvalid("'" + name + "' is missing");
    Grid->GetFieldData()->AddArray(array);
  }
  EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Grid), "");
}

TEST_F(DamagedArrays, WrongSize)
{
  Grid->GetFieldData()->GetArray("PixelExact.Mesh.Centre")->SetNumberOfTuples(7);
  ExpectInvalid("'PixelExact.Mesh.Centre' has 7 x 3");
}

TEST_F(DamagedArrays, CoefficientsCutShort)
{
  Grid->GetFieldData()->GetArray("PixelExact.Field.f.Coefficients")->SetNumberOfTuples(60);
  ExpectInvalid("field 'f', element 7");
}

TEST_F(DamagedArrays, WrongType)
{
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(Grid->GetFieldData()->GetArray("PixelExact.Mesh.Coefficients"));
  floats->SetName("PixelExact.Mesh.Coefficients");
  Grid->GetFieldData()->AddArray(floats);
  ExpectInvalid("float, not double");
}

TEST_F(DamagedArrays, NaNInTheMap)
{
  Grid->GetFieldData()->GetArray("PixelExact.Mesh.Coefficients")->SetComponent(30, 0, kNaN);
  ExpectInvalid("element 1: a coordinate coefficient is NaN");
}

TEST_F(DamagedArrays, ImpossibleOrder)
{
  Grid->GetFieldData()->GetArray("PixelExact.Mesh.Spaces")->SetComponent(0, 2, 77);
  ExpectInvalid("77");
}

TEST_F(DamagedArrays, IdOutOfRange)
{
  Grid->GetCellData()->GetArray("PixelExactElementId")->SetComponent(3, 0, 8);
  ExpectInvalid("cell 3 names element 8 of 8");
}
} // namespace
