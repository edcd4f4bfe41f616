// SPDX-License-Identifier: BSD-3-Clause
// Pieces of files are the whole, with the numbers of the whole where they are cut from one file.
#include "ElementFacts.h"
#include "SeriesFiles.h"

#include "HighOrderArrays.h"
#include "vtkHighOrderFileReader.h"
#include "vtkMFEMReader.h"
#include "vtkNektarReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// The facts of all pieces at the end of a pipeline; each element is in one of them.
Facts FactsOfPieces(vtkAlgorithm& end, int pieces)
{
  Facts all;
  for (int piece = 0; piece < pieces; ++piece)
  {
    end.UpdatePiece(piece, pieces, 0);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(end.GetOutputDataObject(0));
    if (grid->GetNumberOfCells() > 0)
    {
      for (auto& [number, facts] : FactsOf(grid))
      {
        EXPECT_TRUE(all.emplace(number, facts).second) << number;
      }
    }
  }
  return all;
}

void ExpectPieces(vtkAlgorithm& end)
{
  end.UpdatePiece(0, 1, 0);
  const Facts whole = FactsOf(end.GetOutputDataObject(0));
  ASSERT_GT(whole.size(), 10U);
  EXPECT_EQ(FactsOfPieces(end, 3), whole);
  EXPECT_EQ(FactsOfPieces(end, 2), whole);
  // The whole once more: a reader keeps the mesh of what it read last.
  end.UpdatePiece(0, 1, 0);
  EXPECT_EQ(FactsOf(end.GetOutputDataObject(0)), whole);
}

TEST(Pieces, OfNektarFiles)
{
  const std::string folder = PIXELEXACT_DATA_DIR "/nek_tet_varp/nek_tet_varp";
  vtkNew<vtkNektarReader> reader;
  reader->SetFileName((folder + ".xml").c_str());
  reader->AddFieldFileName((folder + ".fld").c_str());
  ExpectPieces(*reader);
}

TEST(Pieces, OfMfemFilesWithAttributes)
{
  const std::string folder = PIXELEXACT_DATA_DIR "/mfem_escher_tet_darcy_p3/";
  vtkNew<vtkMFEMReader> reader;
  reader->SetFileName((folder + "mfem_escher_tet_darcy_p3.mesh").c_str());
  reader->AddGridFunctionFileName((folder + "flux.gf").c_str());
  ExpectPieces(*reader);
}

TEST(Pieces, OfVtkFiles)
{
  vtkNew<vtkHighOrderSeriesReader> reader;
  reader->SetFileName(PIXELEXACT_DATA_DIR "/toroid_prism_g3_p4.vtu");
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputConnection(reader->GetOutputPort());
  ExpectPieces(*convert);
}

TEST(Pieces, MoreThanElementsAreEmpty)
{
  vtkNew<vtkHighOrderSeriesReader> reader;
  reader->SetFileName(PIXELEXACT_DATA_DIR "/fichera_hex_g3_p4.vtu");
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  vtkNew<Messages> heard;
  heard->Watch(convert);
  convert->SetInputConnection(reader->GetOutputPort());
  convert->UpdatePiece(0, 1, 0);
  const Facts whole = FactsOf(convert->GetOutputDataObject(0));
  EXPECT_EQ(FactsOfPieces(*convert, 2 * static_cast<int>(whole.size()) + 1), whole);
  EXPECT_EQ(heard->errors, "");
}

using PieceFiles = SeriesFiles;

TEST_F(PieceFiles, FilesOfASolversCoefficientsAreOneGrid)
{
  std::vector<std::string> names;
  for (const int part : { 0, 1 })
  {
    // The arrays have different widths: the second grid's field has a higher order.
    const auto grid = Converted(Slabs(2 * part, 2, 1.0));
    const std::vector<Space> own(2, UniformSpace(Shape::Hexahedron, 1 + part));
    OwnedExpansion p;
    p.Allocate(own, 1);
    std::ranges::fill(p.coefficients, 0.25 + part);
    StoreField(grid, "p", { std::move(p) }, Origin::Coefficients);
    names.push_back("part" + std::to_string(part) + ".vtu");
    Write(names.back(), grid);
  }
  WritePieces("both.pvtu", names);
  Reader->SetFileName((Folder / "both.pvtu").c_str());
  Reader->Update();
  ASSERT_EQ(Heard->errors, "");
  auto* both = vtkUnstructuredGrid::SafeDownCast(Reader->GetOutputDataObject(0));
  const auto model = HighOrderModel::From(both);
  ASSERT_EQ(model->GetMesh().Elements(), 4);
  const Field* p = model->FindField("p");
  ASSERT_NE(p, nullptr);
  EXPECT_EQ(p->values.SpaceOf(0).MaxOrder(), 1);
  EXPECT_EQ(p->values.SpaceOf(3).MaxOrder(), 2);
  EXPECT_EQ(p->values.Coefficients(0)[0], 0.25);
  EXPECT_EQ(p->values.Coefficients(3)[0], 1.25);
  // Reads the pieces one by one, as two processes would.
  for (const int piece : { 0, 1 })
  {
    Reader->UpdatePiece(piece, 2, 0);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(Reader->GetOutputDataObject(0));
    EXPECT_EQ(HighOrderModel::From(grid)->GetMesh().Elements(), 2);
  }
}
} // namespace
