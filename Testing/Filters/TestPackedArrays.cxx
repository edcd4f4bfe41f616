// SPDX-License-Identifier: BSD-3-Clause
// Packed coefficients behind VTK's filters: each cell keeps its own, or the change is noticed.
#include "ElementFacts.h"
#include "Support.h"

#include "HighOrderModel.h"
#include "PackedArrays.h"
#include "vtkHighOrderPack.h"
#include "vtkHighOrderUnpack.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkClipDataSet.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPointDataToCellData.h"
#include "vtkThreshold.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid Packed(vtkDataObject* data, int modes = 0)
{
  vtkNew<vtkHighOrderPack> pack;
  pack->SetInputDataObject(data);
  pack->SetMinimumModes(modes);
  pack->Update();
  return vtkUnstructuredGrid::SafeDownCast(pack->GetOutputDataObject(0));
}

Grid ReadMfem(const std::string& folder, const std::string& mesh, const std::string& field)
{
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((std::string(PIXELEXACT_DATA_DIR "/") + folder + "/" + mesh).c_str());
  reader->AddGridFunctionFileName(
    (std::string(PIXELEXACT_DATA_DIR "/") + folder + "/" + field).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// An H(div) field and one of L2 on curved tetrahedra.
Grid Escher()
{
  return ReadMfem("mfem_escher_tet_darcy_p3", "mfem_escher_tet_darcy_p3.mesh", "flux.gf");
}

/// Orders that vary from element to element.
Grid Varying()
{
  vtkNew<vtkNektarReader> reader;
  const std::string folder = PIXELEXACT_DATA_DIR "/nek_tet_varp/nek_tet_varp";
  reader->SetFileName((folder + ".xml").c_str());
  reader->AddFieldFileName((folder + ".fld").c_str());
  reader->Update();
  return reader->GetOutput();
}

template <class Filter>
Grid Filtered(Filter& filter, vtkUnstructuredGrid* grid)
{
  filter.SetInputData(grid);
  filter.Update();
  return vtkUnstructuredGrid::SafeDownCast(filter.GetOutputDataObject(0));
}

std::string Problem(vtkUnstructuredGrid* grid)
{
  return vtkHighOrderGrid::CheckCoefficients(grid);
}

/// Splits a grid into two parts and appends them in reverse order.
Grid Subdivided(vtkUnstructuredGrid* grid)
{
  const vtkIdType half = grid->GetNumberOfCells() / 2;
  vtkNew<vtkAppendFilter> append;
  for (const bool second : { true, false })
  {
    vtkNew<vtkIdList> cells;
    for (vtkIdType cell = second ? half : 0; cell < (second ? grid->GetNumberOfCells() : half);
         ++cell)
    {
      cells->InsertNextId(cell);
    }
    vtkNew<vtkExtractCells> extract;
    extract->SetCellList(cells);
    append->AddInputData(Filtered(*extract, grid));
  }
  append->Update();
  return append->GetOutput();
}

TEST(PackedArrays, KeepEveryBitAndNothingInFieldData)
{
  for (const Grid& grid : { Escher(), Varying(),
         Grid(Converted(ReadGrid(PIXELEXACT_DATA_DIR "/toroid_prism_g3_p4.vtu"))) })
  {
    ASSERT_GT(grid->GetNumberOfCells(), 0);
    const Grid packed = Packed(grid);
    EXPECT_TRUE(IsPacked(packed));
    EXPECT_TRUE(vtkHighOrderGrid::IsHighOrder(packed));
    EXPECT_EQ(packed->GetFieldData()->GetArray("PixelExact.Mesh.Coefficients"), nullptr);
    EXPECT_EQ(Problem(packed), "");
    EXPECT_EQ(FactsOf(packed), FactsOf(grid));
    vtkNew<vtkHighOrderUnpack> unpack;
    unpack->SetInputDataObject(packed);
    unpack->Update();
    auto* back = vtkUnstructuredGrid::SafeDownCast(unpack->GetOutputDataObject(0));
    EXPECT_FALSE(IsPacked(back));
    EXPECT_EQ(FactsOf(back), FactsOf(grid));
    EXPECT_EQ(back->GetFieldData()->GetNumberOfArrays(), grid->GetFieldData()->GetNumberOfArrays());
  }
}

TEST(PackedArrays, AppendedPartsAreTheWhole)
{
  for (const Grid& grid : { Escher(), Varying() })
  {
    const Grid appended = Subdivided(Packed(grid));
    EXPECT_EQ(Problem(appended), "");
    EXPECT_EQ(FactsOf(appended), FactsOf(grid));
    // Without packing the coefficients are lost.
    EXPECT_NE(
      vtkHighOrderGrid::IsHighOrder(Subdivided(grid)) ? Problem(Subdivided(grid)) : "lost", "-");
  }
}

TEST(PackedArrays, AppendedTwiceIsTwice)
{
  const Grid packed = Packed(Escher());
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(packed);
  append->AddInputData(packed);
  append->Update();
  EXPECT_EQ(Problem(append->GetOutput()), "");
  EXPECT_EQ(HighOrderModel::From(append->GetOutput())->GetMesh().Elements(),
    2 * packed->GetNumberOfCells());
}

TEST(PackedArrays, DifferentGridsNeedTheSameWidth)
{
  const Grid a = Converted(Boxes(2));
  Grid b = Converted(ReadGrid(PIXELEXACT_DATA_DIR "/fichera_hex_g3_p4.vtu"));
  const auto appended = [](const Grid& first, const Grid& second)
  {
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(first);
    append->AddInputData(second);
    append->Update();
    return Grid(append->GetOutput());
  };
  const std::string problem = Problem(appended(Packed(a), Packed(b)));
  EXPECT_NE(problem.find("PixelExact.Packed.Mesh.Coefficients"), std::string::npos) << problem;
  const Grid both = appended(Packed(a, 125), Packed(b, 125));
  EXPECT_EQ(Problem(both), "");
  EXPECT_EQ(both->GetNumberOfCells(), a->GetNumberOfCells() + b->GetNumberOfCells());
  // Blocks get one width by themselves.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, a);
  blocks->SetBlock(1, b);
  vtkNew<vtkHighOrderPack> pack;
  pack->SetInputDataObject(blocks);
  pack->Update();
  auto* packed = vtkMultiBlockDataSet::SafeDownCast(pack->GetOutputDataObject(0));
  const Grid merged = appended(vtkUnstructuredGrid::SafeDownCast(packed->GetBlock(0)),
    vtkUnstructuredGrid::SafeDownCast(packed->GetBlock(1)));
  EXPECT_EQ(Problem(merged), "");
}

TEST(PackedArrays, FilesKeepThem)
{
  const Grid grid = Escher();
  const std::string file = ::testing::TempDir() + "packed.vtu";
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(Packed(grid));
  writer->SetFileName(file.c_str());
  writer->Write();
  EXPECT_EQ(FactsOf(ReadGrid(file)), FactsOf(grid));
}

TEST(PackedArrays, ChangedGeometryIsStale)
{
  const Grid packed = Packed(Escher());
  vtkNew<vtkTransform> transform;
  transform->Translate(1e-9, 0.0, 0.0);
  vtkNew<vtkTransformFilter> move;
  move->SetTransform(transform);
  EXPECT_NE(Problem(Filtered(*move, packed)).find("moved"), std::string::npos);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(packed->GetCenter());
  vtkNew<vtkClipDataSet> clip;
  clip->SetClipFunction(plane);
  EXPECT_NE(Problem(Filtered(*clip, packed)).find("(Clip)"), std::string::npos);
}

TEST(PackedArrays, ChangedValuesAreStale)
{
  const Grid packed = Packed(Converted(Boxes(2)));
  ASSERT_EQ(Problem(packed), "");
  vtkNew<vtkDoubleArray> other;
  other->DeepCopy(packed->GetPointData()->GetArray("f"));
  other->SetValue(3, 17.0);
  packed->GetPointData()->AddArray(other);
  packed->Modified();
  EXPECT_NE(Problem(packed).find("'f'"), std::string::npos) << Problem(packed);
}

TEST(PackedArrays, PointsThatBecameOneAreTheSame)
{
  // VTK merges points that coincide up to rounding, with the values of one of them.
  const Grid packed = Packed(Converted(ReadGrid(PIXELEXACT_DATA_DIR "/toroid_hex_g3_p6.vtu")));
  const Facts before = FactsOf(packed);
  const auto shift = [&](double place, double value)
  {
    double x[3];
    packed->GetPoints()->GetPoint(7, x);
    packed->GetPoints()->SetPoint(7, x[0] + place, x[1], x[2]);
    vtkDataArray* u = packed->GetPointData()->GetArray("u");
    u->SetComponent(7, 0, u->GetComponent(7, 0) + value);
    packed->GetPoints()->Modified();
    u->Modified();
    packed->Modified();
  };
  shift(1e-16, 1e-15);
  EXPECT_EQ(Problem(packed), "");
  EXPECT_EQ(FactsOf(packed), before);
  shift(0.0, 1e-8);
  EXPECT_NE(Problem(packed).find("'u'"), std::string::npos);
  shift(0.0, -1e-8);
  EXPECT_EQ(Problem(packed), "");
  shift(1e-8, 0.0);
  EXPECT_NE(Problem(packed).find("moved"), std::string::npos);
}

TEST(PackedArrays, ChangedTuplesAreStale)
{
  for (const char* name : { "Mesh.Coefficients", "Mesh.Place", "Field.flux.Coefficients" })
  {
    const Grid packed = Packed(Escher());
    const std::string full = std::string("PixelExact.Packed.") + name;
    vtkNew<vtkDoubleArray> other;
    other->DeepCopy(packed->GetCellData()->GetArray(full.c_str()));
    other->SetComponent(4, 2, std::nextafter(other->GetComponent(4, 2), 1e300));
    packed->GetCellData()->AddArray(other);
    packed->Modified();
    EXPECT_NE(Problem(packed).find("cell 4 has packed coefficients"), std::string::npos)
      << Problem(packed);
  }
  // Blanked cells, as filters fill what a part lacks.
  const Grid packed = Packed(Escher());
  for (const char* name : { "PixelExact.Packed.Field.flux.Space",
         "PixelExact.Packed.Field.flux.Marks", "PixelExact.Packed.Field.flux.Coefficients" })
  {
    vtkDataArray* array = packed->GetCellData()->GetArray(name);
    const auto other = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    other->DeepCopy(array);
    for (int c = 0; c < other->GetNumberOfComponents(); ++c)
    {
      other->SetComponent(0, c, 0.0);
    }
    packed->GetCellData()->AddArray(other);
  }
  packed->Modified();
  EXPECT_NE(Problem(packed), "");
}

TEST(PackedArrays, MissingArraysAreNamed)
{
  const Grid packed = Packed(Escher());
  packed->GetCellData()->RemoveArray("PixelExact.Packed.Mesh.Place");
  EXPECT_NE(Problem(packed).find("'PixelExact.Packed.Mesh.Place'"), std::string::npos)
    << Problem(packed);
}

TEST(PackedArrays, ConversionUnpacks)
{
  const Grid grid = Escher();
  Conversion conversion(Packed(grid));
  EXPECT_EQ(conversion.messages->errors, "");
  EXPECT_FALSE(IsPacked(conversion.Output()));
  EXPECT_EQ(FactsOf(conversion.Output()), FactsOf(grid));
}

TEST(PackedArrays, PackedAgainIsTheSame)
{
  const Grid grid = Varying();
  EXPECT_EQ(FactsOf(Packed(Packed(grid), 800)), FactsOf(grid));
}

TEST(PackedArrays, StaleInputIsRefused)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 0.2, 1.0);
  vtkNew<vtkClipDataSet> clip;
  clip->SetClipFunction(plane);
  vtkNew<vtkHighOrderPack> pack;
  vtkNew<Messages> messages;
  messages->Watch(pack);
  pack->SetInputDataObject(Filtered(*clip, Escher()));
  pack->Update();
  EXPECT_NE(messages->errors.find("(Clip)"), std::string::npos) << messages->errors;
  EXPECT_EQ(pack->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
}
} // namespace
