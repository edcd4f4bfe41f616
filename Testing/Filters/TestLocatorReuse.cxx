// SPDX-License-Identifier: BSD-3-Clause
// A new time step of the same mesh keeps the locator; anything else does not.
#include "Support.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <thread>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

const Locator* LocatorOf(vtkUnstructuredGrid* grid)
{
  const auto model = HighOrderModel::From(grid);
  return model->HasLocator() ? &model->GetLocator() : nullptr;
}

class LocatorReuse : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkHighOrderGrid> Grid = Converted(Boxes(3));
  std::shared_ptr<HighOrderModel> Model = HighOrderModel::From(Grid);
  const Locator* First = &Model->GetLocator();
};

TEST_F(LocatorReuse, ShallowCopiesShare)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(Grid);
  EXPECT_NE(HighOrderModel::From(copy), Model);
  EXPECT_EQ(LocatorOf(copy), First);
  vtkNew<vtkUnstructuredGrid> deep;
  deep->DeepCopy(Grid);
  EXPECT_EQ(LocatorOf(deep), nullptr);
}

TEST_F(LocatorReuse, OtherFieldsShare)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(Grid);
  AddPointField(copy, "g", std::vector<double>(copy->GetNumberOfPoints(), 2.0));
  EXPECT_EQ(LocatorOf(copy), First);
  Grid->Modified();
  EXPECT_FALSE(Model->IsCurrent(Grid));
  EXPECT_EQ(LocatorOf(Grid), First);
  EXPECT_EQ(&Grid->GetModel()->GetLocator(), First);
}

TEST_F(LocatorReuse, AMovedPointIsRefused)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(Grid);
  vtkNew<vtkPoints> points;
  points->DeepCopy(copy->GetPoints());
  points->SetPoint(13, 0.1, 0.2, 0.3);
  copy->SetPoints(points);
  EXPECT_THROW(HighOrderModel::From(copy), StaleData);
  EXPECT_EQ(LocatorOf(Grid), First);
  // The points change in place, and only the grid is marked as modified.
  Grid->GetPoints()->GetData()->SetComponent(13, 0, 0.1);
  Grid->Modified();
  EXPECT_THROW(HighOrderModel::From(Grid), StaleData);
}

TEST_F(LocatorReuse, ModifiedMeshArraysAreReadAnew)
{
  for (const char* name : { "Coefficients", "Centre", "Size", "Uncertainty", "Offset", "Spaces" })
  {
    const auto before = HighOrderModel::From(Grid);
    ASSERT_FALSE(before->GetLocator().Bounds().Contains(Vec3(2.0)));
    Grid->GetFieldData()->GetArray((std::string("PixelExact.Mesh.") + name).c_str())->Modified();
    EXPECT_EQ(LocatorOf(Grid), nullptr) << name;
  }
  Grid->GetFieldData()->GetArray("PixelExact.Mesh.Size")->SetComponent(0, 0, -1.0);
  Grid->GetFieldData()->GetArray("PixelExact.Mesh.Size")->Modified();
  EXPECT_THROW(HighOrderModel::From(Grid), InvalidData);
}

TEST_F(LocatorReuse, SubsetsHaveTheirOwn)
{
  vtkNew<vtkExtractCells> part;
  part->AddCellRange(0, 9);
  part->SetInputData(Grid);
  part->Update();
  EXPECT_EQ(LocatorOf(part->GetOutput()), nullptr);
  EXPECT_EQ(HighOrderModel::From(part->GetOutput())->GetMesh().Elements(), 10);
  // Also without ids, which the mesh arrays alone do not show.
  Grid->GetCellData()->RemoveArray("PixelExactElementId");
  const auto whole = HighOrderModel::From(Grid);
  part->Update();
  EXPECT_THROW(HighOrderModel::From(part->GetOutput()), StaleData);
}

TEST_F(LocatorReuse, EndsWithItsLastModel)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(Grid);
  auto other = HighOrderModel::From(copy);
  Model.reset();
  EXPECT_EQ(LocatorOf(copy), First);
  other.reset();
  EXPECT_EQ(LocatorOf(copy), nullptr);
}

TEST_F(LocatorReuse, IsSafeInThreads)
{
  Model.reset();
  std::vector<const Locator*> found(8);
  std::vector<std::shared_ptr<HighOrderModel>> models(found.size());
  std::vector<std::thread> threads;
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> grids;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    grids.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
    grids[i]->ShallowCopy(Grid);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        models[i] = HighOrderModel::From(grids[i]);
        found[i] = &models[i]->GetLocator();
      });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(std::vector(found.size(), found[0]), found);
}

/// Time steps as readers make them: other objects of equal values.
class ConvertedSteps : public ::testing::Test
{
protected:
  vtkNew<vtkUnstructuredGridToHighOrderGrid> Filter;
  std::shared_ptr<HighOrderModel> Held;
  std::set<const Locator*> Locators;

  static vtkSmartPointer<vtkUnstructuredGrid> Step(int step)
  {
    auto grid = Boxes(2);
    vtkDataArray* f = grid->GetPointData()->GetArray("f");
    for (vtkIdType i = 0; i < f->GetNumberOfTuples(); ++i)
    {
      f->SetComponent(i, 0, f->GetComponent(i, 0) + step);
    }
    return grid;
  }
  /// Whether the locator of the step before is used.
  bool Reuses(vtkUnstructuredGrid* grid)
  {
    Filter->SetInputData(grid);
    Filter->Update();
    Held = HighOrderModel::From(Filter->GetHighOrderOutput()); // ends the old one after this
    const bool had = Held->HasLocator();
    Locators.insert(&Held->GetLocator());
    return had;
  }
  double AtCentre()
  {
    const double xi[3] = { 0.0, 0.0, 0.0 };
    vtkNew<vtkDoubleArray> value;
    Filter->GetHighOrderOutput()->EvaluateField("f", 0, xi, value);
    return value->GetValue(0);
  }
};

TEST_F(ConvertedSteps, Share)
{
  EXPECT_FALSE(Reuses(Step(0)));
  EXPECT_DOUBLE_EQ(AtCentre(), 1.5);
  for (const int step : { 1, 2 })
  {
    EXPECT_TRUE(Reuses(Step(step)));
    EXPECT_DOUBLE_EQ(AtCentre(), 1.5 + step);
  }
  EXPECT_EQ(Locators.size(), 1U);
}

TEST_F(ConvertedSteps, ShareAlsoWhereCellsAreLeftOut)
{
  const auto withTriangle = [](int step)
  {
    auto grid = Step(step);
    const vtkIdType ids[3] = { 0, 1, 3 };
    grid->InsertNextCell(5, 3, ids); // VTK_TRIANGLE
    return grid;
  };
  EXPECT_FALSE(Reuses(withTriangle(0)));
  EXPECT_TRUE(Reuses(withTriangle(1)));
  EXPECT_EQ(Filter->GetNumberOfSkippedCells(), 1);
}

TEST_F(ConvertedSteps, DoNotShareAnotherMesh)
{
  const std::vector<std::pair<const char*, std::function<void(vtkUnstructuredGrid*)>>> changes{
    { "point", [](auto* grid) { grid->GetPoints()->SetPoint(0, -0.5, 0.0, 0.0); } },
    { "precision",
      [](auto* grid)
      {
        vtkNew<vtkPoints> floats;
        floats->SetDataTypeToFloat();
        for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
        {
          floats->InsertNextPoint(grid->GetPoint(i));
        }
        grid->SetPoints(floats);
      } },
    { "connectivity",
      [](auto* grid)
      {
        vtkNew<vtkIdList> ids;
        grid->GetCellPoints(0, ids);
        const vtkIdType turned[8] = { ids->GetId(1), ids->GetId(2), ids->GetId(3), ids->GetId(0),
          ids->GetId(5), ids->GetId(6), ids->GetId(7), ids->GetId(4) };
        grid->GetCells()->ReplaceCellAtId(0, 8, turned);
      } },
    { "number",
      [](auto* grid)
      {
        const vtkIdType ids[8] = { 0, 1, 4, 3, 9, 10, 13, 12 };
        grid->InsertNextCell(12, 8, ids);
      } },
  };
  for (const auto& [what, change] : changes)
  {
    Reuses(Step(0));
    ASSERT_TRUE(Reuses(Step(1)));
    const auto other = Step(2);
    change(other);
    EXPECT_FALSE(Reuses(other)) << what;
    EXPECT_EQ(vtkHighOrderGrid::CheckCoefficients(Filter->GetHighOrderOutput()), "") << what;
  }
}

TEST_F(ConvertedSteps, SeeChangesInPlace)
{
  const auto grid = Step(0);
  EXPECT_FALSE(Reuses(grid));
  grid->GetPoints()->SetPoint(0, -0.5, 0.0, 0.0);
  grid->Modified(); // the points are not marked as modified
  EXPECT_FALSE(Reuses(grid));
  double x[3];
  const double corner[3] = { -1.0, -1.0, -1.0 };
  ASSERT_TRUE(Filter->GetHighOrderOutput()->MapForward(0, corner, x));
  EXPECT_DOUBLE_EQ(x[0], -0.5);
}

TEST_F(ConvertedSteps, MendOutputThatWasChanged)
{
  Reuses(Step(0));
  vtkDataArray* sizes =
    Filter->GetHighOrderOutput()->GetFieldData()->GetArray("PixelExact.Mesh.Size");
  sizes->SetComponent(0, 0, 64.0);
  sizes->Modified();
  EXPECT_FALSE(Reuses(Step(1)));
  EXPECT_LT(Held->GetMesh().size[0], 2.0);
}

TEST_F(ConvertedSteps, RepeatTheirDiagnostics)
{
  const auto inverted = [](int step)
  {
    auto grid = Step(step);
    const vtkIdType ids[8] = { 9, 10, 13, 12, 0, 1, 4, 3 };
    grid->GetCells()->ReplaceCellAtId(0, 8, ids);
    return grid;
  };
  vtkNew<Messages> messages;
  messages->Watch(Filter);
  Reuses(inverted(0));
  const int lines = Filter->GetNumberOfDiagnostics();
  ASSERT_GT(lines, 0);
  EXPECT_TRUE(Reuses(inverted(1)));
  EXPECT_EQ(Filter->GetNumberOfDiagnostics(), lines);
  Filter->DiagnoseOff();
  EXPECT_TRUE(Reuses(inverted(2)));
  EXPECT_EQ(Filter->GetNumberOfDiagnostics(), 0);
}
} // namespace
