// SPDX-License-Identifier: BSD-3-Clause
// Faces with attributes, on their way from a solver's file through VTK.
#include "LoadMesh.h"

#include "Core/Base/Error.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

vtkSmartPointer<vtkUnstructuredGrid> LoadDarcyMesh()
{
  return LoadMesh(kData / "mfem_escher_tet_darcy_p3" / "mfem_escher_tet_darcy_p3.mesh");
}

std::vector<AttributedFace> Listed(vtkDataObject* data)
{
  const auto model = HighOrderModel::From(data);
  const auto faces = model->BoundaryFaces();
  return { faces.begin(), faces.end() };
}

std::string Message(vtkUnstructuredGrid* grid)
{
  try
  {
    HighOrderModel::From(grid);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

template <class Ask>
std::string Refusal(const Ask& ask)
{
  try
  {
    ask();
  }
  catch (const InvalidData& error)
  {
    return error.what();
  }
  return {};
}

/// The file's 48 triangles have the attributes 1 to 48.
TEST(BoundaryAttributes, AreThoseOfTheFile)
{
  const auto faces = Listed(LoadDarcyMesh());
  const auto counts = CountByAttribute(faces);
  ASSERT_EQ(counts.size(), 48U);
  EXPECT_EQ(counts.begin()->first, 1);
  EXPECT_EQ(counts.rbegin()->first, 48);
  EXPECT_TRUE(std::ranges::all_of(counts, [](const auto& entry) { return entry.second == 1; }));
  EXPECT_TRUE(std::ranges::is_sorted(faces));
}

TEST(BoundaryAttributes, FollowTheElementsThatAreLeft)
{
  const auto grid = LoadDarcyMesh();
  const auto all = Listed(grid);
  const std::vector<vtkIdType> kept{ 3, 7, 20, 41 };
  vtkNew<vtkIdList> cells;
  for (const vtkIdType cell : kept)
  {
    cells->InsertNextId(cell);
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(grid);
  extract->SetCellList(cells);
  extract->Update();
  std::vector<AttributedFace> expected;
  for (AttributedFace face : all)
  {
    const auto at = std::ranges::find(kept, face.face.element);
    if (at != kept.end())
    {
      face.face.element = static_cast<std::int32_t>(at - kept.begin());
      expected.push_back(face);
    }
  }
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(Listed(extract->GetOutput()), expected);
}

TEST(BoundaryAttributes, OfBlocksCountOnFromBlockToBlock)
{
  const auto grid = LoadDarcyMesh();
  const auto one = Listed(grid);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(2);
  blocks->SetBlock(0, grid);
  blocks->SetBlock(1, LoadDarcyMesh());
  const auto both = Listed(blocks);
  ASSERT_EQ(both.size(), 2 * one.size());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    AttributedFace moved = one[i];
    moved.face.element += static_cast<std::int32_t>(grid->GetNumberOfCells());
    EXPECT_EQ(both[i], one[i]);
    EXPECT_EQ(both[one.size() + i], moved);
  }
}

TEST(BoundaryAttributes, OthersAreRefusedWithThoseThatThereAre)
{
  const std::vector<AttributedFace> faces{ { { 0, 1 }, 2 }, { { 0, 3 }, 5 }, { { 4, 0 }, 2 } };
  EXPECT_EQ(FacesOfAttribute(faces, 2), (std::vector<ElementFace>{ { 0, 1 }, { 4, 0 } }));
  EXPECT_EQ(Refusal([&] { FacesOfAttribute(faces, 3); }),
    "there is no boundary attribute 3; the input has: 2, 5.");
  const auto others = Listed(Converted(Boxes(2)));
  EXPECT_TRUE(others.empty());
  EXPECT_NE(Refusal([&] { FacesOfAttribute(others, 3); }).find("lists none"), std::string::npos);
}

TEST(BoundaryAttributes, ArraysThatNameNoFaceAreRefused)
{
  const auto change = [](const char* name, vtkIdType entry, double value)
  {
    const auto grid = LoadDarcyMesh();
    vtkDataArray* array =
      grid->GetFieldData()->GetArray((std::string("PixelExact.Mesh.Boundary.") + name).c_str());
    array->SetComponent(entry, 0, value);
    array->Modified();
    return Message(grid);
  };
  EXPECT_EQ(change("Attribute", 3, -7), "");
  EXPECT_NE(change("Face", 3, 4).find("entry 3, name face 4 of a tetrahedron"), std::string::npos);
  EXPECT_NE(change("Face", 3, -1).find("face -1"), std::string::npos);
  EXPECT_NE(change("Element", 5, 42).find("element 42 of 42"), std::string::npos);
  const auto grid = LoadDarcyMesh();
  grid->GetFieldData()->RemoveArray("PixelExact.Mesh.Boundary.Face");
  EXPECT_NE(Message(grid).find("PixelExact.Mesh.Boundary.Face"), std::string::npos);
}

/// A conversion of what VTK's cells are has no list of another mesh.
TEST(BoundaryAttributes, AreDroppedWithTheCoefficients)
{
  const auto grid = LoadDarcyMesh();
  RemoveHighOrderArrays(grid);
  EXPECT_FALSE(grid->GetFieldData()->HasArray("PixelExact.Mesh.Boundary.Face"));
}
} // namespace
