// SPDX-License-Identifier: BSD-3-Clause
// Files that do not mean what VTK makes of them are distinguished from those that do.
#include "Support.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

std::string DiagnosticsOf(const std::filesystem::path& file)
{
  Conversion conversion(ReadGrid(file));
  EXPECT_TRUE(conversion.done) << conversion.messages->errors;
  std::string all;
  for (int i = 0; i < conversion.filter->GetNumberOfDiagnostics(); ++i)
  {
    all += conversion.filter->GetDiagnostic(i) + "\n";
  }
  // All diagnostics were also issued as warnings.
  EXPECT_EQ(all.empty(), conversion.messages->warnings.empty());
  return all;
}

class SharedDiagnostics : public ::testing::Test
{
protected:
  static std::string Of(const std::string& file)
  {
    return DiagnosticsOf(std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / file);
  }
  void SetUp() override
  {
    if (!std::filesystem::exists(PIXELEXACT_SHARED_DATA_DIR))
    {
      GTEST_SKIP() << "no shared data on this machine";
    }
  }
};

TEST(Diagnostics, SoundFilesAreSilent)
{
  for (const auto& file : std::filesystem::directory_iterator(PIXELEXACT_DATA_DIR))
  {
    if (file.path().extension() == ".vtu")
    {
      EXPECT_EQ(DiagnosticsOf(file.path()), "") << file.path();
    }
  }
}

TEST_F(SharedDiagnostics, MirroredWedges)
{
  EXPECT_NE(
    Of("mfem_toroid_prism_g3_p4/mfem_toroid_prism_g3_p4.vtu").find("mirrored"), std::string::npos);
  EXPECT_EQ(Of("mfem_toroid_prism_g3_p4/mfem_toroid_prism_g3_p4_vtkwedge.vtu"), "");
}

TEST_F(SharedDiagnostics, WarpedNodes)
{
  EXPECT_NE(Of("dolfinx_tet_g3_p4_gllwarped/dolfinx_tet_g3_p4_gllwarped.vtu").find("Lobatto"),
    std::string::npos);
  EXPECT_EQ(Of("dolfinx_tet_g3_p3/dolfinx_tet_g3_p3.vtu"), "");
}

TEST_F(SharedDiagnostics, NodesOfFoundFiles)
{
  EXPECT_NE(Of("found_2026_11/gll-nodes-all-curved/t6_gll_p4_warped.vtu").find("--nodes gll"),
    std::string::npos);
  EXPECT_NE(Of("found_2026_11/mid-nodes-other-order/t1_hex20_wrong.vtu")
              .find("the mid nodes fit other edges"),
    std::string::npos);
  EXPECT_EQ(Of("found_2026_11/mid-nodes-other-order/t1_hex20_right.vtu"), "");
  // VTK's own reader leaves the first of two cells in another order.
  EXPECT_NE(Of("found_2026_11/vtu-two-pieces-old-order/two_pieces_v0.1.vtu").find("VTK 8"),
    std::string::npos);
  EXPECT_EQ(Of("found_2026_11/vtu-two-pieces-old-order/same_v2.2.vtu"), "");
}

TEST_F(SharedDiagnostics, InvertedElements)
{
  const std::string lines = Of("glvis_mesh_explorer_g4/glvis_mesh_explorer_g4.vtu");
  // The file's 78 elements with det J <= 0 at its own quadrature points; ours are finer.
  EXPECT_NE(lines.find(" of 448 elements"), std::string::npos) << lines;
  EXPECT_GE(std::stoi(lines), 78);
}

TEST(Diagnostics, TwistedAndMirroredBoxes)
{
  auto grid = Boxes(2);
  Conversion sound(grid);
  EXPECT_EQ(sound.filter->GetNumberOfDiagnostics(), 0);

  grid->GetPoints()->SetPoint(13, 2.0, 2.0, 2.0); // the middle point, out through a corner
  Conversion folded(grid);
  ASSERT_EQ(folded.filter->GetNumberOfDiagnostics(), 1);
  EXPECT_NE(folded.filter->GetDiagnostic(0).find("changes sign"), std::string::npos);

  folded.filter->DiagnoseOff();
  folded.Run();
  EXPECT_EQ(folded.filter->GetNumberOfDiagnostics(), 0);
}
/// Two cells of a type whose points VTK's own parametric coordinates give, moved by a bend;
/// `order`: position in the cell by place in the connectivity.
std::string DiagnosticsOfReordered(int type, const std::vector<int>& order)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  const double* at = cell->GetParametricCoords();
  std::vector<double> xyz;
  for (const int node : order)
  {
    const double* r = at + 3 * static_cast<std::ptrdiff_t>(node);
    xyz.insert(xyz.end(),
      { 2 * r[0] + 0.1 * r[1] * r[1], r[1] + 0.15 * r[2] * r[2], r[2] + 0.05 * r[0] * r[0] });
  }
  Conversion conversion(OneCell(type, xyz));
  EXPECT_TRUE(conversion.done) << conversion.messages->errors;
  std::string all;
  for (int i = 0; i < conversion.filter->GetNumberOfDiagnostics(); ++i)
  {
    all += conversion.filter->GetDiagnostic(i) + "\n";
  }
  return all;
}

TEST(Diagnostics, NodesInOtherProgramsOrdersAreNamed)
{
  struct Case
  {
    int type;
    std::vector<int> edges; ///< from the first node that is no corner on
    std::string program;
    std::string moves;
  };
  const std::vector<Case> cases{
    { VTK_QUADRATIC_HEXAHEDRON, { 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15 }, "Exodus",
      "12, 13, 14, 15, 16, 17, 18, 19 (counted from 0) belong to 16, 17, 18, 19, 12, 13, 14, 15" },
    { VTK_TRIQUADRATIC_HEXAHEDRON,
      { 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15, 26, 24, 25, 20, 21, 22, 23 }, "Exodus",
      "20, 21, 22, 23, 24, 25, 26 (counted from 0) belong to" },
    { VTK_QUADRATIC_HEXAHEDRON, { 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14 }, "Gmsh",
      "belong to 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14" },
    { VTK_QUADRATIC_WEDGE, { 6, 7, 8, 12, 13, 14, 9, 10, 11 }, "Exodus", "belong to 12, 13, 14" },
    { VTK_QUADRATIC_TETRA, { 4, 5, 6, 7, 9, 8 }, "Gmsh", "8, 9 (counted from 0) belong to 9, 8" },
    { VTK_QUADRATIC_HEXAHEDRON, { 9, 8, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 }, "",
      "8, 9 (counted from 0) belong to 9, 8. Maps" },
  };
  for (const auto& [type, edges, program, moves] : cases)
  {
    const auto first = static_cast<std::size_t>(*std::ranges::min_element(edges));
    std::vector<int> order(first);
    std::iota(order.begin(), order.end(), 0);
    std::vector<int> sound(first + edges.size());
    std::iota(sound.begin(), sound.end(), 0);
    EXPECT_EQ(DiagnosticsOfReordered(type, sound), "") << type;
    order.insert(order.end(), edges.begin(), edges.end());
    const std::string lines = DiagnosticsOfReordered(type, order);
    EXPECT_NE(lines.find("the mid nodes fit other edges"), std::string::npos) << type;
    EXPECT_NE(lines.find(program), std::string::npos) << lines;
    EXPECT_NE(lines.find(moves), std::string::npos) << lines;
    EXPECT_LT(lines.find("mid nodes"), lines.find("changes sign")) << lines;
  }
}

TEST(Diagnostics, CellsThatAreThereTwiceAreReported)
{
  const auto grid = Boxes(3);
  const vtkNew<vtkIdList> points;
  grid->GetCellPoints(4, points);
  vtkNew<vtkIdList> turned; // the same cell from another corner
  for (const int corner : { 1, 2, 3, 0, 5, 6, 7, 4 })
  {
    turned->InsertNextId(points->GetId(corner));
  }
  grid->InsertNextCell(VTK_HEXAHEDRON, turned);
  Conversion conversion(grid);
  ASSERT_EQ(conversion.filter->GetNumberOfDiagnostics(), 1);
  const std::string line = conversion.filter->GetDiagnostic(0);
  EXPECT_NE(
    line.find("1 cell that the grid has more than once (first: cells 4 and 27)"), std::string::npos)
    << line;
}
} // namespace
