// SPDX-License-Identifier: BSD-3-Clause
// Files that do not mean what VTK makes of them are distinguished from those that do.
#include "Support.h"

#include <gtest/gtest.h>

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
  // All of it was also said aloud.
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
} // namespace
