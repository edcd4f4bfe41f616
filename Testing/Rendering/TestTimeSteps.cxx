// SPDX-License-Identifier: BSD-3-Clause
// From one time step to the next of the same mesh, what draws it keeps the locator.
#include "BoxGrid.h"

#include "FrameSource.h"
#include "HighOrderModel.h"
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

TEST(TimeSteps, FrameSourceKeepsTheLocator)
{
  FrameSource source;
  const auto first = testing::BoxGrid(2);
  const Locator* locator = &source.ModelOf(first)->GetLocator();
  // Nobody else holds the model.
  const auto second = NextStep(first);
  EXPECT_TRUE(source.ModelOf(second)->HasLocator());
  EXPECT_EQ(&source.ModelOf(second)->GetLocator(), locator);
  EXPECT_EQ(source.Counters().models, 2);
  EXPECT_FALSE(source.ModelOf(testing::BoxGrid(2))->HasLocator());
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
