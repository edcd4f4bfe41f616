// SPDX-License-Identifier: BSD-3-Clause
// What vtkHighOrderProbe adds on request: enclosures and owners, against the solver's values.
#include "OracleCheck.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

namespace pixelexact::testing
{
namespace
{
class ProbeAdditions : public ::testing::Test
{
protected:
  void SetUp() override
  {
    Truth = ReadTable(FindData("toroid_prism_g3_p4.oracle.csv"));
    Grid = ReadGrid(FindData("toroid_prism_g3_p4.vtu"));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t i = 0; i < Truth.at("x").size(); ++i)
    {
      points->InsertNextPoint(Truth.at("x")[i], Truth.at("y")[i], Truth.at("z")[i]);
    }
    points->InsertNextPoint(1e3, 0.0, 0.0);
    vtkNew<vtkPolyData> where;
    where->SetPoints(points);
    Probe->SetInputData(where);
    Probe->SetSourceData(Grid);
  }

  vtkPointData* Run()
  {
    Probe->Update();
    return vtkDataSet::SafeDownCast(Probe->GetOutputDataObject(0))->GetPointData();
  }

  Table Truth;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkNew<vtkHighOrderProbe> Probe;
};
} // namespace

TEST_F(ProbeAdditions, AreOffByDefault)
{
  vtkPointData* found = Run();
  for (const char* name : { "u_lower", "u_upper", "Owners", "Coverage" })
  {
    EXPECT_EQ(found->GetArray(name), nullptr) << name;
  }
}

TEST_F(ProbeAdditions, EnclosuresHoldTheSolversValues)
{
  Probe->EnclosuresOn();
  vtkPointData* found = Run();
  vtkDataArray* lower = found->GetArray("u_lower");
  vtkDataArray* upper = found->GetArray("u_upper");
  ASSERT_NE(lower, nullptr);
  ASSERT_NE(upper, nullptr);
  const auto& expected = Truth.at("u");
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    EXPECT_LE(lower->GetComponent(at, 0), expected[i]);
    EXPECT_GE(upper->GetComponent(at, 0), expected[i]);
    EXPECT_LT(upper->GetComponent(at, 0) - lower->GetComponent(at, 0), 1e-11);
  }
  EXPECT_TRUE(std::isnan(lower->GetComponent(static_cast<vtkIdType>(expected.size()), 0)));
}

TEST_F(ProbeAdditions, OwnersCountPreimages)
{
  Probe->OwnersOn();
  vtkPointData* found = Run();
  vtkDataArray* owners = found->GetArray("Owners");
  vtkDataArray* coverage = found->GetArray("Coverage");
  ASSERT_NE(owners, nullptr);
  ASSERT_NE(coverage, nullptr);
  const auto points = static_cast<vtkIdType>(Truth.at("x").size());
  for (vtkIdType i = 0; i < points; ++i)
  {
    EXPECT_GE(owners->GetComponent(i, 0), 1.0);
    EXPECT_EQ(coverage->GetComponent(i, 0), 1.0);
  }
  EXPECT_EQ(owners->GetComponent(points, 0), 0.0);
  EXPECT_EQ(coverage->GetComponent(points, 0), 0.0);
}
} // namespace pixelexact::testing
