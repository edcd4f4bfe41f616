// SPDX-License-Identifier: BSD-3-Clause
// From one time step to the next of the same mesh, what draws it keeps the locator.
#include "BoxGrid.h"

#include "HighOrderModel.h"
#include "Views/GridModel.h"
#include "vtkHighOrderMapper.h"

#include <gtest/gtest.h>

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> NextStep(vtkUnstructuredGrid* grid)
{
  auto next = vtkSmartPointer<vtkUnstructuredGrid>::New();
  next->ShallowCopy(grid);
  return next;
}
} // namespace

TEST(TimeSteps, GridModelKeepsTheLocator)
{
  GridModel model;
  const auto first = testing::BoxGrid(2);
  const Locator* locator = &model.Of(first)->GetLocator();
  // Nobody else holds the model.
  const auto second = NextStep(first);
  EXPECT_TRUE(model.Of(second)->HasLocator());
  EXPECT_EQ(&model.Of(second)->GetLocator(), locator);
  EXPECT_EQ(model.Builds(), 2);
  EXPECT_FALSE(model.Of(testing::BoxGrid(2))->HasLocator());
}

TEST(TimeSteps, MapperKeepsTheLocator)
{
  vtkNew<vtkHighOrderMapper> mapper;
  const auto first = testing::BoxGrid(2);
  mapper->SetInputData(first);
  mapper->GetBounds(); // locates
  const auto second = NextStep(first);
  mapper->SetInputData(second);
  EXPECT_TRUE(HighOrderModel::From(second)->HasLocator()); // the mapper's, who holds the first
  mapper->GetBounds();
  EXPECT_EQ(mapper->GetNumberOfModelBuilds(), 2);
}
} // namespace pixelexact
