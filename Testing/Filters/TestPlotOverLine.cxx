// SPDX-License-Identifier: BSD-3-Clause
#include "Support.h"

#include "Core/Math/Vec.h"
#include "vtkHighOrderPlotOverLine.h"
#include "vtkHighOrderProbe.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkHighOrderPlotOverLine> Along(
  vtkDataObject* grid, const Vec3& from, const Vec3& to)
{
  auto line = vtkSmartPointer<vtkHighOrderPlotOverLine>::New();
  line->SetInputDataObject(grid);
  line->SetPoint1(from.x, from.y, from.z);
  line->SetPoint2(to.x, to.y, to.z);
  return line;
}

vtkSmartPointer<vtkHighOrderGrid> Solution(const std::string& name)
{
  return Converted(ReadGrid(std::filesystem::path(PIXELEXACT_DATA_DIR) / (name + ".vtu")));
}

double Get(vtkPolyData* data, const char* name, vtkIdType i)
{
  return data->GetPointData()->GetArray(name)->GetComponent(i, 0);
}

/// The points whose element differs from that of the point before.
std::vector<vtkIdType> Changes(vtkPolyData* data)
{
  std::vector<vtkIdType> changes;
  for (vtkIdType i = 1; i < data->GetNumberOfPoints(); ++i)
  {
    if (Get(data, "Element", i) != Get(data, "Element", i - 1))
    {
      changes.push_back(i);
    }
  }
  return changes;
}

TEST(PlotOverLine, BoundariesOfBoxesAreWhereTheyAre)
{
  const auto line = Along(Boxes(2), { -0.5, 0.3, 0.3 }, { 1.5, 0.3, 0.3 });
  line->SetResolution(7);
  line->Update();
  vtkPolyData* output = line->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  const std::vector<vtkIdType> changes = Changes(output);
  ASSERT_EQ(changes.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double where = 0.5 + 0.5 * static_cast<double>(k); // from Point1, the mesh being [0, 1]
    EXPECT_NEAR(Get(output, "arc_length", changes[k] - 1), where, 1e-14);
    EXPECT_NEAR(Get(output, "arc_length", changes[k]), where, 1e-14);
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double x = output->GetPoint(i)[0];
    EXPECT_NEAR(Get(output, "arc_length", i), x + 0.5, 1e-15);
    if (Get(output, "Verdict", i) == 1.0)
    {
      EXPECT_NEAR(Get(output, "f", i), x + 0.6 + 0.9, 1e-14);
    }
    else
    {
      EXPECT_TRUE(std::isnan(Get(output, "f", i)));
      EXPECT_TRUE(x < 0.0 || x > 1.0);
    }
  }
}

TEST(PlotOverLine, WithoutBoundariesItIsAProbe)
{
  const auto grid = Solution("toroid_hex_g3_p6");
  const auto line = Along(grid, { -1.5, -0.1, 0.05 }, { 1.5, 0.2, 0.05 });
  line->SetResolution(500);
  line->ElementBoundariesOff();
  line->ComputeGradientsOn();
  line->EnclosuresOn();
  line->AddField("u");
  line->Update();
  vtkPolyData* output = line->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 501);
  vtkNew<vtkHighOrderProbe> probe;
  vtkNew<vtkPolyData> points;
  points->SetPoints(output->GetPoints());
  probe->SetInputData(points);
  probe->SetSourceData(grid);
  probe->ComputeGradientsOn();
  probe->EnclosuresOn();
  probe->AddField("u");
  probe->Update();
  vtkPointData* probed = vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), probed->GetNumberOfArrays() + 1);
  for (int a = 0; a < probed->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* theirs = probed->GetArray(a);
    vtkDataArray* ours = output->GetPointData()->GetArray(theirs->GetName());
    ASSERT_NE(ours, nullptr) << theirs->GetName();
    for (vtkIdType i = 0; i < 501; ++i)
    {
      const double value = theirs->GetComponent(i, 0);
      EXPECT_TRUE(ours->GetComponent(i, 0) == value ||
        (std::isnan(value) && std::isnan(ours->GetComponent(i, 0))));
    }
  }
}

TEST(PlotOverLine, CurvedBoundariesAndJumps)
{
  for (const char* name : { "toroid_hex_g3_p6", "periodic_hex_dg_g3_p4" })
  {
    const auto grid = Solution(name);
    const double* box = grid->GetBounds();
    const auto line = Along(grid, { box[0], 0.6 * box[2] + 0.4 * box[3], 0.5 * (box[4] + box[5]) },
      { box[1], 0.4 * box[2] + 0.6 * box[3], 0.5 * (box[4] + box[5]) });
    line->SetResolution(400);
    line->AddField("u");
    line->Update();
    vtkPolyData* output = line->GetOutput();
    const std::vector<vtkIdType> changes = Changes(output);
    EXPECT_GT(changes.size(), 3U);
    double largestJump = 0.0;
    for (const vtkIdType i : changes)
    {
      EXPECT_LT(Get(output, "arc_length", i) - Get(output, "arc_length", i - 1), 1e-13);
      const double jump = std::abs(Get(output, "u", i) - Get(output, "u", i - 1));
      largestJump = std::isnan(jump) ? largestJump : std::max(largestJump, jump);
    }
    if (std::string(name) == "toroid_hex_g3_p6")
    {
      EXPECT_LT(largestJump, 1e-12);
    }
    else
    {
      EXPECT_GT(largestJump, 1e-6);
    }
  }
}

TEST(PlotOverLine, RefusesWhatIsNoLineAndFieldsThatAreNotThere)
{
  const auto same = Along(Boxes(2), { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 });
  const auto unnamed = Along(Boxes(2), { 0.0, 0.5, 0.5 }, { 0.5, 0.5, 0.5 });
  unnamed->AddField("none");
  const auto endless = Along(Boxes(2), { 0.0, 0.5, 0.5 }, { std::nan(""), 0.5, 0.5 });
  for (vtkHighOrderPlotOverLine* line : { same.Get(), unnamed.Get(), endless.Get() })
  {
    vtkNew<Messages> messages;
    messages->Watch(line);
    line->Update();
    EXPECT_FALSE(messages->errors.empty());
    EXPECT_EQ(line->GetOutput()->GetNumberOfPoints(), 0);
  }
}
} // namespace
