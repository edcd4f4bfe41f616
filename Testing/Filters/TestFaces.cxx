// SPDX-License-Identifier: BSD-3-Clause
// Boundaries of solvers' meshes: closed, and those that the files list.
#include "ClosedSurface.h"
#include "LoadMesh.h"

#include "Core/Location/Locator.h"
#include "HighOrderModel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct BoundaryCase
{
  const char* file;
  bool lists = false; ///< the file lists its whole boundary, and nothing else
};

const std::filesystem::path kShared = PIXELEXACT_SHARED_DATA_DIR;

/// The path of a file in the project's own data, else in the shared folder; empty where there is
/// neither.
std::filesystem::path Find(const std::string& name)
{
  for (const auto& folder : { kData, kShared })
  {
    if (std::filesystem::exists(folder / name))
    {
      return folder / name;
    }
  }
  return {};
}

class FacesOfFiles : public ::testing::TestWithParam<BoundaryCase>
{
};

TEST_P(FacesOfFiles, Close)
{
  const auto file = Find(GetParam().file);
  if (file.empty())
  {
    GTEST_SKIP() << "no shared data on this machine";
  }
  const auto grid = LoadMesh(file);
  const auto model = HighOrderModel::From(grid);
  static_cast<void>(model->GetLocator()); // not counted in the time below
  EXPECT_FALSE(model->HasFaces());
  const auto begin = std::chrono::steady_clock::now();
  const FaceTable& faces = model->Faces();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_TRUE(model->HasFaces());
  const SurfaceIntegrals integrals = IntegrateBoundary(model->GetMesh(), faces);
  std::printf("[ measured ] %-60s %d elements: %lld boundary, %lld interior, %lld hanging, %lld "
              "partly; %.0f ns a face; off by %.1e of the area, %.1e of the volume\n",
    GetParam().file, model->GetMesh().Elements(),
    static_cast<long long>(faces.CountOf(FaceKind::Boundary)),
    static_cast<long long>(faces.CountOf(FaceKind::Interior)),
    static_cast<long long>(faces.CountOf(FaceKind::Hanging)),
    static_cast<long long>(faces.CountOf(FaceKind::Partly)),
    seconds.count() * 1e9 / static_cast<double>(faces.Faces()),
    LargestOf(integrals.area) / integrals.surface, integrals.volume / integrals.inside - 1.0);
  EXPECT_EQ(faces.CountOf(FaceKind::Partly), 0);
  EXPECT_LT(LargestOf(integrals.area), 1e-11 * integrals.surface);
  EXPECT_NEAR(integrals.volume, integrals.inside, 1e-11 * integrals.inside);
}

/// The faces of a file's list are its boundary, where it lists that and nothing else.
TEST_P(FacesOfFiles, AreThoseThatTheFileLists)
{
  const auto file = Find(GetParam().file);
  if (!GetParam().lists || file.empty())
  {
    GTEST_SKIP() << (GetParam().lists ? "no shared data on this machine" : "lists no boundary");
  }
  const auto grid = LoadMesh(file);
  const auto model = HighOrderModel::From(grid);
  const Mesh& mesh = model->GetMesh();
  std::set<ElementFace> listed;
  for (const AttributedFace& entry : model->BoundaryFaces())
  {
    listed.insert(entry.face);
  }
  std::set<ElementFace> boundary;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    for (int f = 0; f < static_cast<int>(pixelexact::FacesOf(mesh.ShapeOf(e)).size()); ++f)
    {
      if (model->Faces().KindOf(e, f) == FaceKind::Boundary)
      {
        boundary.insert({ e, f });
      }
    }
  }
  EXPECT_EQ(listed, boundary);
}

/// Faces that the mesh identifies have the attributes of both sides, because the file does not
/// distinguish them.
TEST(FacesOfPeriodicMeshes, HaveTheAttributesOfBothEnds)
{
  const auto file = kShared / "mfem_periodic_hex_dg_g3_p4" / "mfem_periodic_hex_dg_g3_p4.mesh";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no shared data on this machine";
  }
  const auto grid = LoadMesh(file);
  const auto model = HighOrderModel::From(grid);
  const auto counts = CountByAttribute(model->BoundaryFaces());
  ASSERT_EQ(counts.size(), 6U);
  for (const auto& [attribute, count] : counts)
  {
    EXPECT_EQ(count, 18) << attribute;
  }
  for (const AttributedFace& entry : model->BoundaryFaces())
  {
    EXPECT_EQ(model->Faces().KindOf(entry.face.element, entry.face.face), FaceKind::Boundary);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, FacesOfFiles,
  ::testing::Values(BoundaryCase{ "mfem49_tinyzoo_g3_p5/mfem49_tinyzoo_g3_p5.mesh", true },
    BoundaryCase{ "mfem_escher_tet_darcy_p3/mfem_escher_tet_darcy_p3.mesh", true },
    BoundaryCase{ "nek_hex_aniso_p3p5p7/nek_hex_aniso_p3p5p7.xml" },
    BoundaryCase{ "nek_prism_curved_p7/nek_prism_curved_p7.xml" },
    BoundaryCase{ "nek_pyramid_curved_p6/nek_pyramid_curved_p6.xml" },
    BoundaryCase{ "nek_tet_varp/nek_tet_varp.xml" }, BoundaryCase{ "dolfinx_hex_g2_p4.vtu" },
    BoundaryCase{ "periodic_hex_dg_g3_p4.vtu" }, BoundaryCase{ "toroid_hex_g3_p6.vtu" },
    BoundaryCase{ "toroid_prism_g3_p4.vtu" }, BoundaryCase{ "escher_tet_g3_p3.vtu" },
    BoundaryCase{ "fichera_hex_g3_p4.vtu" },
    BoundaryCase{ "mfem49_pyramid_g3_p4/mfem49_pyramid_g3_p4.mesh", true },
    BoundaryCase{ "mfem_fichera_hex_amr_g3_p3/mfem_fichera_hex_amr_g3_p3.mesh", true },
    BoundaryCase{ "mfem_fichera_hex_amr_g3_p3/mfem_fichera_hex_amr_g3_p3.vtu" },
    BoundaryCase{ "mfem_fichera_hex_g3_p4/mfem_fichera_hex_g3_p4.mesh", true },
    BoundaryCase{ "mfem_beam_hex_elast_p4/mfem_beam_hex_elast_p4.mesh", true },
    BoundaryCase{ "mfem_toroid_prism_g3_p4/mfem_toroid_prism_g3_p4.mesh", true },
    BoundaryCase{ "mfem_periodic_hex_dg_g3_p4/mfem_periodic_hex_dg_g3_p4.mesh" },
    BoundaryCase{ "glvis_laghos_hex_g2_dg/glvis_laghos_hex_g2_dg.mesh" },
    BoundaryCase{ "mfem_escher_tet_21k_p3/mfem_escher_tet_21k_p3.mesh.gz", true },
    BoundaryCase{ "mfem_escher_tet_21k_p3/mfem_escher_tet_21k_p3_zlib.vtu" },
    BoundaryCase{ "dray_crazy_hex_bernstein_g20/dray_crazy_hex_bernstein_g20.mesh" },
    BoundaryCase{ "nek_ns_cylinder_hexprism_p4/nek_ns_cylinder_hexprism_p4.xml" },
    BoundaryCase{ "nek_ns_cylinder_paperscale_p3/nek_ns_cylinder_paperscale_p3.xml" },
    BoundaryCase{ "nek_ns_kovasznay_tet_p9/nek_ns_kovasznay_tet_p9.xml" },
    BoundaryCase{ "nek_ns_prismhex_p3/nek_ns_prismhex_p3.xml" },
    BoundaryCase{ "nek_ns_pipe_prism_tet_p3/nek_ns_pipe_prism_tet_p3.xml" },
    BoundaryCase{ "nek_allshapes_p4_p6/nek_allshapes_p4_p6.xml" },
    BoundaryCase{ "nek_found_smallmesh_tet_p3/smallmesh.xml" },
    BoundaryCase{ "found_vtk_hex_3x3x3_o4/hex_3x3x3_o4.vtk" },
    BoundaryCase{ "found_vtk_tets_in_1x1x1_block_o6/tets_in_1x1x1_block_o6.vtk" }),
  [](const auto& test)
  {
    std::string name = std::filesystem::path(test.param.file).filename().string();
    std::ranges::replace_if(
      name, [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
  });
} // namespace
