// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderTruncate in a pipeline: what is left, and its bounds.
#include "LoadMesh.h"
#include "Support.h"

#include "Core/Location/Sample.h"
#include "HighOrderModel.h"

#include "vtkFieldData.h"
#include "vtkHighOrderTruncate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkUnstructuredGrid> Truncated(vtkHighOrderTruncate* filter, vtkDataObject* grid)
{
  filter->SetInputData(grid);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

TEST(Truncate, ValuesMoveByNoMoreThanTheBound)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  const Conversion conversion(grid);
  ASSERT_TRUE(conversion.done);
  vtkNew<vtkHighOrderTruncate> filter;
  filter->SetOrder(4);
  filter->AddField("u");
  const auto output = Truncated(filter, conversion.Output());
  const auto whole = HighOrderModel::From(conversion.Output());
  const auto model = HighOrderModel::From(output);
  // The mesh is the same one.
  EXPECT_EQ(&whole->GetLocator(), &model->GetLocator());
  EXPECT_EQ(output->GetPointData()->GetArray("u"), nullptr);
  const Field* u = model->FindField("u");
  ASSERT_NE(u, nullptr);
  EXPECT_EQ(u->values.SpaceOf(0).MaxOrder(), 4);
  vtkDataArray* change = output->GetFieldData()->GetArray("u_LargestChange");
  ASSERT_NE(change, nullptr);
  const double bound = change->GetTuple1(0);
  std::vector<Vec3> xi;
  for (int k = 0; k < 125; ++k)
  {
    xi.emplace_back(-1.0 + 0.5 * (k % 5), -1.0 + 0.5 * (k / 5 % 5), -1.0 + 0.5 * (k / 25));
  }
  std::vector<double> before(xi.size());
  std::vector<double> after(xi.size());
  double largest = 0.0;
  for (int e = 0; e < model->GetMesh().Elements(); ++e)
  {
    EvaluateAt(whole->GetMesh(), *whole->FindField("u"), e, xi, before, {});
    EvaluateAt(model->GetMesh(), *u, e, xi, after, {});
    for (std::size_t k = 0; k < xi.size(); ++k)
    {
      largest = std::max(largest, std::fabs(after[k] - before[k]));
    }
  }
  EXPECT_LE(largest, bound + 1e-14);
  EXPECT_GT(largest, 0.2 * bound);
}

TEST(Truncate, PlainGridsAreConvertedAndOtherFieldsStay)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  vtkNew<vtkHighOrderTruncate> filter;
  filter->SetOrder(1);
  filter->BoundsOff();
  filter->AddField("u");
  const auto output = Truncated(filter, grid);
  ASSERT_EQ(output->GetNumberOfCells(), grid->GetNumberOfCells());
  EXPECT_EQ(output->GetFieldData()->GetArray("u_LargestChange"), nullptr);
  EXPECT_EQ(HighOrderModel::From(output)->FindField("u")->values.SpaceOf(0).MaxOrder(), 1);
}

TEST(Truncate, FieldsThatAreNotThereAreNamed)
{
  const auto grid = ReadGrid(kData / "toroid_hex_g3_p6.vtu");
  vtkNew<vtkHighOrderTruncate> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->AddField("missing");
  EXPECT_EQ(Truncated(filter, grid)->GetNumberOfCells(), 0);
  EXPECT_NE(messages->errors.find("'missing'"), std::string::npos) << messages->errors;
}
} // namespace
