// SPDX-License-Identifier: BSD-3-Clause
#include "Support.h"

#include "vtkCellData.h"
#include "vtkHighOrderCertifier.h"
#include "vtkHighOrderLinearResample.h"
#include "vtkHighOrderProbe.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// Boxes(2) and, behind a null block, the same moved by 1 along x, with the same values. Their flat
/// indices are 1 and 3.
vtkSmartPointer<vtkMultiBlockDataSet> Neighbours()
{
  const auto moved = Boxes(2);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[3];
    moved->GetPoint(i, x);
    moved->GetPoints()->SetPoint(i, x[0] + 1.0, x[1], x[2]);
  }
  auto neighbours = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  neighbours->SetNumberOfBlocks(3);
  neighbours->SetBlock(0, Boxes(2));
  neighbours->SetBlock(2, moved);
  return neighbours;
}

double PeriodicValue(double x, double y, double z)
{
  return std::fmod(x, 1.0) + 2.0 * y + 3.0 * z;
}

vtkSmartPointer<vtkPolyData> Points(const std::vector<std::array<double, 3>>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& x : positions)
  {
    points->InsertNextPoint(x.data());
  }
  auto where = vtkSmartPointer<vtkPolyData>::New();
  where->SetPoints(points);
  return where;
}

const std::vector<std::array<double, 3>> kPositions{ { 0.3, 0.6, 0.9 }, { 1.3, 0.6, 0.9 },
  { 2.5, 0.5, 0.5 } };

void ExpectProbed(vtkDataObject* output)
{
  auto* probed = vtkPolyData::SafeDownCast(output);
  ASSERT_NE(probed, nullptr) << output->GetClassName();
  ASSERT_EQ(probed->GetNumberOfPoints(), 3);
  const auto get = [&](const char* name, vtkIdType i)
  { return probed->GetPointData()->GetArray(name)->GetComponent(i, 0); };
  for (const vtkIdType inside : { 0, 1 })
  {
    const auto& x = kPositions[static_cast<std::size_t>(inside)];
    EXPECT_EQ(get("Verdict", inside), 1.0);
    EXPECT_NEAR(get("f", inside), PeriodicValue(x[0], x[1], x[2]), 1e-14);
    EXPECT_EQ(get("Element", inside), 6.0);
    EXPECT_EQ(get("Block", inside), inside == 0 ? 1.0 : 3.0);
    EXPECT_EQ(get("Owners", inside), 1.0);
  }
  EXPECT_EQ(get("Verdict", 2), 0.0);
  EXPECT_EQ(get("Element", 2), -1.0);
  EXPECT_EQ(get("Block", 2), -1.0);
}

TEST(CompositeFilters, ProbeTakesAllBlocksAsOne)
{
  const auto plain = Neighbours();
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputDataObject(plain);
  convert->Update();
  vtkDataObject* converted = convert->GetOutputDataObject(0);
  const auto mixed = Neighbours();
  mixed->SetBlock(0, vtkMultiBlockDataSet::SafeDownCast(converted)->GetBlock(0));
  for (vtkDataObject* source :
    std::initializer_list<vtkDataObject*>{ plain, converted, mixed.Get() })
  {
    vtkNew<vtkHighOrderProbe> probe;
    probe->SetInputData(Points(kPositions));
    probe->SetSourceData(source);
    probe->OwnersOn();
    probe->Update();
    ExpectProbed(probe->GetOutputDataObject(0));
    // Points of several blocks, too, each as it is.
    vtkNew<vtkMultiBlockDataSet> where;
    where->SetBlock(0, Points(kPositions));
    where->SetBlock(1, Points(kPositions));
    probe->SetInputData(where);
    probe->Update();
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(probe->GetOutputDataObject(0));
    ASSERT_NE(blocks, nullptr);
    ExpectProbed(blocks->GetBlock(0));
    ExpectProbed(blocks->GetBlock(1));
  }
}

TEST(CompositeFilters, ProbeSeesLeavesThatChange)
{
  const auto plain = Neighbours();
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(Points(kPositions));
  probe->SetSourceData(plain);
  probe->OwnersOn();
  probe->Update();
  ExpectProbed(probe->GetOutputDataObject(0));
  auto* moved = vtkUnstructuredGrid::SafeDownCast(plain->GetBlock(2));
  moved->GetPointData()->GetArray("f")->Fill(5.0);
  moved->GetPointData()->GetArray("f")->Modified();
  plain->Modified();
  probe->Update();
  EXPECT_NEAR(vtkPolyData::SafeDownCast(probe->GetOutputDataObject(0))
                ->GetPointData()
                ->GetArray("f")
                ->GetComponent(1, 0),
    5.0, 1e-14);
}

TEST(CompositeFilters, ResampleMakesOneImage)
{
  vtkNew<vtkHighOrderLinearResample> resample;
  resample->SetInputDataObject(Neighbours());
  resample->SetDimensions(8, 3, 3);
  resample->Update();
  vtkImageData* image = resample->GetOutput();
  ASSERT_NE(image, nullptr);
  const double* bounds = image->GetBounds();
  EXPECT_EQ(bounds[0], 0.0);
  EXPECT_EQ(bounds[1], 2.0);
  ASSERT_EQ(image->GetNumberOfPoints(), 72);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    if (x[0] < 1.99)
    {
      EXPECT_NEAR(image->GetPointData()->GetArray("f")->GetComponent(i, 0),
        PeriodicValue(x[0], x[1], x[2]), 1e-13);
    }
  }
}

TEST(CompositeFilters, CertifierAndConverterGoBlockByBlock)
{
  vtkNew<vtkHighOrderCertifier> certifier;
  certifier->SetInputDataObject(Neighbours());
  certifier->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(certifier->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (const unsigned int block : { 0U, 2U })
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(grid, nullptr);
    for (vtkIdType e = 0; e < 8; ++e)
    {
      EXPECT_EQ(grid->GetCellData()->GetArray("Verdict")->GetComponent(e, 0), 0.0);
    }
  }
}

TEST(CompositeFilters, WhatIsNoGridIsNamed)
{
  const auto neighbours = Neighbours();
  neighbours->SetBlock(1, Points(kPositions));
  vtkPolyData::SafeDownCast(neighbours->GetBlock(1))->Allocate(1);
  const vtkIdType point = 0;
  vtkPolyData::SafeDownCast(neighbours->GetBlock(1))->InsertNextCell(VTK_VERTEX, 1, &point);
  vtkNew<Messages> messages;
  vtkNew<vtkHighOrderProbe> probe;
  messages->Watch(probe);
  probe->SetInputData(Points(kPositions));
  probe->SetSourceData(neighbours);
  probe->Update();
  EXPECT_NE(messages->errors.find("block 2 is a vtkPolyData"), std::string::npos)
    << messages->errors;
}
} // namespace
