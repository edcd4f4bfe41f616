// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "Core/Base/Error.h"
#include "vtkHighOrderPicker.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

namespace pixelexact
{
namespace
{
using testing::BoxGrid;
using testing::CutScene;
using testing::ErrorObserver;
using testing::Window;

/// The cells of BoxGrid(2) on one side of x = 0.
vtkSmartPointer<vtkUnstructuredGrid> Half(bool right)
{
  const auto whole = BoxGrid(2);
  auto half = vtkSmartPointer<vtkUnstructuredGrid>::New();
  half->SetPoints(whole->GetPoints());
  half->GetCellData()->CopyAllocate(whole->GetCellData());
  half->GetFieldData()->ShallowCopy(whole->GetFieldData());
  for (vtkIdType e = 0; e < whole->GetNumberOfCells(); ++e)
  {
    if ((e % 2 == 1) == right)
    {
      vtkNew<vtkIdList> ids;
      whole->GetCellPoints(e, ids);
      half->GetCellData()->CopyData(
        whole->GetCellData(), e, half->InsertNextCell(VTK_HEXAHEDRON, ids));
    }
  }
  return half;
}

/// BoxGrid(2) as two blocks, with an empty leaf and a null one between them, whose flat indices are
/// 2 and 5.
vtkSmartPointer<vtkMultiBlockDataSet> Children()
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetNumberOfBlocks(1);
  inner->SetBlock(0, Half(false));
  auto children = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  children->SetNumberOfBlocks(4);
  children->SetBlock(0, inner);
  children->SetBlock(1, vtkNew<vtkUnstructuredGrid>());
  children->SetBlock(3, Half(true));
  return children;
}

class CompositeInput : public ::testing::Test
{
protected:
  CompositeInput()
  {
    Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, Errors);
    Window.Renderer->AddActor(Scene.Cut);
    CutScene::Look(Window.Renderer, false);
  }

  std::string ErrorsOf(vtkDataObject* data)
  {
    Errors->Text.clear();
    Scene.Mapper->SetInputData(data);
    Window.RenderWindow->Render();
    return Errors->Text;
  }

  CutScene Scene;
  testing::Window Window;
  vtkNew<ErrorObserver> Errors;
};

vtkDataArray* ArrayOf(vtkHighOrderMapper* mapper, const char* name)
{
  return mapper->GetBuffers()->GetPointData()->GetArray(name);
}
} // namespace

TEST_F(CompositeInput, IsOneSceneOfAllLeaves)
{
  Window.Renderer->AddActor(Scene.Sphere);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, Half(false));
  partitions->SetPartition(1, Half(true));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  const auto children = Children();
  for (vtkCompositeDataSet* data :
    std::initializer_list<vtkCompositeDataSet*>{ children, partitions.Get(), collection.Get() })
  {
    EXPECT_EQ(ErrorsOf(data), "") << data->GetClassName();
    Window.Render();
    CutScene::ExpectPicture(Window, { 0, 0, Window::kWidth, Window::kHeight });
    EXPECT_EQ(Scene.Mapper->GetInput(), nullptr);
    EXPECT_EQ(Scene.Mapper->GetCompositeInput(), data);
    for (int c = 0; c < 6; ++c)
    {
      EXPECT_NEAR(Scene.Mapper->GetBounds()[c], c % 2 == 0 ? -1.0 : 1.0, 1e-14);
    }
  }
}

TEST_F(CompositeInput, IsWhatOneGridIsBitForBit)
{
  const auto whole = BoxGrid(2);
  ASSERT_EQ(ErrorsOf(whole), "");
  const vtkSmartPointer<vtkImageData> expected = Scene.Mapper->GetBuffers();
  ASSERT_EQ(ErrorsOf(Children()), "");
  vtkDataArray* block = ArrayOf(Scene.Mapper, "Block");
  ASSERT_NE(block, nullptr);
  EXPECT_EQ(expected->GetPointData()->GetArray("Block"), nullptr);
  int pixels = 0;
  for (vtkIdType i = 0; i < block->GetNumberOfTuples(); ++i)
  {
    const auto same = [&](const char* name)
    {
      const double a = expected->GetPointData()->GetArray(name)->GetTuple1(i);
      const double b = ArrayOf(Scene.Mapper, name)->GetTuple1(i);
      return a == b || (std::isnan(a) && std::isnan(b));
    };
    for (const char* name : { "Value", "Verdict", "Depth" })
    {
      ASSERT_TRUE(same(name)) << name << ", pixel " << i;
    }
    const double x = ArrayOf(Scene.Mapper, "Position")->GetComponent(i, 0);
    if (std::abs(x) > 1e-9)
    {
      ASSERT_TRUE(same("Element")) << "pixel " << i;
      ASSERT_EQ(block->GetTuple1(i), x < 0.0 ? 2.0 : 5.0);
      ++pixels;
    }
    else if (std::isnan(x))
    {
      ASSERT_EQ(block->GetTuple1(i), -1.0);
    }
  }
  EXPECT_GT(pixels, 1000);
}

TEST_F(CompositeInput, PicksAndSelectionsNameTheBlock)
{
  const auto children = Children();
  ASSERT_EQ(ErrorsOf(children), "");
  vtkNew<vtkHighOrderPicker> picker;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(Window.Renderer);
  selector->SetArea(0, 0, Window::kWidth - 1, Window::kHeight - 1);
  ASSERT_TRUE(selector->CaptureBuffers());
  std::array<int, 2> count{};
  for (unsigned int i = 60; i < 240; i += 9)
  {
    ASSERT_NE(picker->Pick(i, 120, 0.0, Window.Renderer), 0);
    const bool right = picker->GetPickPosition()[0] > 0.0;
    ++count[right ? 1 : 0];
    EXPECT_EQ(picker->GetFlatBlockIndex(), right ? 5 : 2);
    EXPECT_EQ(picker->GetCompositeDataSet(), children);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(picker->GetDataSet());
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(grid->GetCellData()->GetArray(kElementIds)->GetTuple1(picker->GetCellId()),
      picker->GetElement() - 1000);
    EXPECT_EQ((picker->GetElement() - 1000) % 2, right ? 1 : 0);
    const unsigned int pixel[2] = { i, 120 };
    const auto info = selector->GetPixelInformation(pixel);
    EXPECT_EQ(info.CompositeID, right ? 5U : 2U);
    EXPECT_EQ(info.AttributeID, picker->GetElement());
  }
  EXPECT_GT(count[0], 2);
  EXPECT_GT(count[1], 2);
}

TEST_F(CompositeInput, FieldsAreThoseOfAllLeaves)
{
  const auto children = Children();
  auto* right = vtkUnstructuredGrid::SafeDownCast(children->GetBlock(3));
  for (int i = right->GetFieldData()->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = right->GetFieldData()->GetAbstractArray(i)->GetName();
    if (name.starts_with(std::string(kFieldPrefix) + "v."))
    {
      right->GetFieldData()->RemoveArray(name.c_str());
    }
  }
  EXPECT_EQ(ErrorsOf(children), "");
  Scene.Mapper->SetFieldName("v");
  const std::string text = ErrorsOf(children);
  EXPECT_NE(text.find("'v'; choose one of 'u', 'nan'"), std::string::npos) << text;
}

TEST_F(CompositeInput, WhatIsNoHighOrderGridIsNamed)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  const auto children = Children();
  children->SetBlock(2, sphere->GetOutput());
  children->GetMetaData(2U)->Set(vtkCompositeDataSet::NAME(), "wall");
  std::string text = ErrorsOf(children);
  EXPECT_NE(text.find("block 4 ('wall') is a vtkPolyData"), std::string::npos) << text;
  EXPECT_NE(text.find("vtkExtractBlock"), std::string::npos) << text;
  // The camera can be placed nevertheless.
  EXPECT_NEAR(Scene.Mapper->GetBounds()[0], -1.0, 1e-14);

  const auto plain = BoxGrid(1);
  RemoveHighOrderArrays(plain);
  children->SetBlock(2, plain);
  text = ErrorsOf(children);
  EXPECT_NE(text.find("block 4 ('wall'): "), std::string::npos) << text;
  EXPECT_NE(text.find("vtkUnstructuredGridToHighOrderGrid"), std::string::npos) << text;
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);

  vtkNew<vtkMultiBlockDataSet> empty;
  EXPECT_THROW(HighOrderModel::From(empty), InvalidData);
  vtkNew<vtkPolyData> other;
  ErrorsOf(other);
  EXPECT_EQ(Scene.Mapper->GetBuffers(), nullptr);
}

TEST_F(CompositeInput, LeavesThatChangeAreSeen)
{
  const auto children = Children();
  ASSERT_EQ(ErrorsOf(children), "");
  const vtkIdType builds = Scene.Mapper->GetNumberOfModelBuilds();
  ASSERT_EQ(ErrorsOf(children), "");
  EXPECT_EQ(Scene.Mapper->GetNumberOfModelBuilds(), builds);
  // Changes a leaf in place, which does not modify the composite data.
  auto* right = vtkUnstructuredGrid::SafeDownCast(children->GetBlock(3));
  vtkDataArray* coefficients = vtkDataArray::SafeDownCast(right->GetFieldData()->GetAbstractArray(
    (std::string(kFieldPrefix) + "u.Coefficients").c_str()));
  for (vtkIdType i = 0; i < coefficients->GetNumberOfTuples(); ++i)
  {
    coefficients->SetTuple1(i, 0.0);
  }
  coefficients->Modified();
  right->Modified();
  ASSERT_EQ(ErrorsOf(children), "");
  EXPECT_EQ(Scene.Mapper->GetNumberOfModelBuilds(), builds + 1);
  vtkDataArray* value = ArrayOf(Scene.Mapper, "Value");
  int zeros = 0;
  for (vtkIdType i = 0; i < value->GetNumberOfTuples(); ++i)
  {
    if (ArrayOf(Scene.Mapper, "Position")->GetComponent(i, 0) > 1e-9)
    {
      ASSERT_EQ(value->GetTuple1(i), 0.0);
      ++zeros;
    }
  }
  EXPECT_GT(zeros, 1000);
}
} // namespace pixelexact
