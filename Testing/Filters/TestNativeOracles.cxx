// SPDX-License-Identifier: BSD-3-Clause
// Solvers' own files, read natively, against the solvers' own libraries.
#include "OracleCheck.h"

#include "vtkGLVisReader.h"
#include "vtkGmshReader.h"
#include "vtkMFEMReader.h"
#include "vtkNekReader.h"
#include "vtkNektarReader.h"

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct NativeCase
{
  const char* folder;
  const char* mesh;
  const char* values; ///< file of the field
  const char* oracle;
  const char* field;
  int order;
  bool folded; ///< overlapping elements: a point may be found in another one
};

std::ostream& operator<<(std::ostream& os, const NativeCase& c)
{
  return os << c.folder << "/" << c.values;
}

/// The whole case where it is at hand; Data/ has some of them, with fewer points.
std::filesystem::path FolderOf(const NativeCase& c)
{
  const std::filesystem::path whole = std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / c.folder;
  return std::filesystem::exists(whole) ? whole
                                        : std::filesystem::path(PIXELEXACT_DATA_DIR) / c.folder;
}

std::string InFolder(const NativeCase& c, const std::string& file)
{
  return (FolderOf(c) / file).string();
}

vtkSmartPointer<vtkHighOrderFileReader> MakeReader(const NativeCase& c)
{
  if (std::string(c.mesh).ends_with(".xml"))
  {
    auto reader = vtkSmartPointer<vtkNektarReader>::New();
    reader->AddFieldFileName(InFolder(c, c.values).c_str());
    return reader;
  }
  if (std::string(c.mesh).ends_with(".saved"))
  {
    return vtkSmartPointer<vtkGLVisReader>::New();
  }
  if (std::string(c.mesh).ends_with(".msh"))
  {
    return vtkSmartPointer<vtkGmshReader>::New();
  }
  if (std::string(c.mesh).ends_with(".nek5000"))
  {
    return vtkSmartPointer<vtkNekReader>::New();
  }
  auto reader = vtkSmartPointer<vtkMFEMReader>::New();
  reader->AddGridFunctionFileName(InFolder(c, c.values).c_str());
  return reader;
}

/// Nektar++ gets a curved face's coefficients from a system with a mass matrix: its own points are
/// off by that one's condition. In exact rational arithmetic these two oracles are off by up to
/// 8e-13 of the element's size where our map is off by 3e-16.
double PointTolerance(const NativeCase& c)
{
  return std::string(c.folder).starts_with("nek_ns_cylinder") ? 2e-12 : 1e-13;
}

class NativeOracles : public ::testing::TestWithParam<NativeCase>
{
};

TEST_P(NativeOracles, AreMet)
{
  const NativeCase c = GetParam();
  // The project's own data have some of the cases without their oracles.
  if (!std::filesystem::exists(FolderOf(c)) || !std::filesystem::exists(InFolder(c, c.oracle)))
  {
    GTEST_SKIP() << c.folder << " with " << c.oracle << " is not on this machine";
  }
  const auto reader = MakeReader(c);
  vtkNew<Messages> messages;
  messages->Watch(reader);
  reader->SetFileName(InFolder(c, c.mesh).c_str());
  reader->Update();
  ASSERT_EQ(messages->errors, "");
  const Table table = ReadOracle(InFolder(c, c.oracle));
  OracleErrors errors;
  MeasureValues(reader->GetHighOrderOutput(), table, c.field, errors);
  MeasurePoints(reader->GetHighOrderOutput(), table, errors);
  PrintErrors(std::string(c.folder) + " " + c.field, errors);
  EXPECT_EQ(errors.outside, 0);
  EXPECT_LE(errors.point, PointTolerance(c));
  if (!c.folded)
  {
    EXPECT_EQ(errors.otherElement, 0);
    EXPECT_LE(errors.value, c.order > 8 ? 1e-11 : 1e-12);
    EXPECT_LE(errors.gradient, 1e-9);
  }
}

const NativeCase kNativeCases[] = {
#define GMSH(name, oracle, field, order)                                                           \
  {                                                                                                \
    name, name ".msh", "", oracle, field, order, false                                             \
  }
  GMSH("gmsh_shell_tet_g3", "oracle.csv", "u", 3),
  GMSH("gmsh_zoo_g2", "oracle.csv", "u", 2),
  GMSH("gmsh_zoo_g2", "oracle.csv", "d", 2),
  GMSH("gmsh_zoo_g2", "oracle_v.csv", "v", 2),
  GMSH("gmsh_zoo_g4", "oracle.csv", "u", 4),
  GMSH("gmsh_zoo_g4", "oracle.csv", "d", 4),
  GMSH("gmsh_zoo_g4", "oracle_v.csv", "v", 4),
#undef GMSH
#define MFEM(name, field, order)                                                                   \
  {                                                                                                \
    name, name ".mesh", field ".gf", "oracle_" field ".csv", field, order, false                   \
  }
  MFEM("dray_crazy_hex_bernstein_g20", "bananas", 20),
  MFEM("glvis_laghos_hex_g2_dg", "e", 2),
  { "glvis_mesh_explorer_g4", "glvis_mesh_explorer_g4.mesh", "c.gf", "oracle_c.csv", "c", 4, true },
  MFEM("mfem49_pyramid_g3_p4", "u", 4),
  MFEM("mfem49_tinyzoo_g3_p5", "u", 5),
  MFEM("mfem_beam_hex_elast_p4", "displacement", 4),
  { "mfem_escher_tet_21k_p3", "mfem_escher_tet_21k_p3.mesh.gz", "u.gf.gz", "oracle_u.csv", "u", 3,
    false },
  MFEM("mfem_escher_tet_darcy_p3", "pressure", 2),
  MFEM("mfem_escher_tet_darcy_p3", "flux", 3),
  MFEM("mfem_escher_tet_p3", "u", 3),
  MFEM("mfem_escher_tet_p8", "u", 8),
  MFEM("mfem_fichera_hex_amr_g3_p3", "u", 3),
  MFEM("mfem_fichera_hex_g3_p4", "u", 4),
  MFEM("mfem_periodic_hex_dg_g3_p4", "u", 4),
  MFEM("mfem_plane_amr_g3_p5", "u", 5),
  MFEM("mfem_plane_amr_g3_p5", "flux", 3),
  MFEM("mfem_plane_amr_g3_p5", "circulation", 3),
  MFEM("mfem_toroid_hex_g3_p16", "u", 16),
  MFEM("mfem_toroid_hex_g3_p6", "u", 6),
  MFEM("mfem_toroid_prism_g3_p4", "u", 4),
#undef MFEM
  { "nek5000_bent", "bent.nek5000", "", "oracle.csv", "pressure", 3, false },
#define NEKTAR(name, field, order)                                                                 \
  {                                                                                                \
    name, name ".xml", name ".fld", "oracle.csv", field, order, false                              \
  }
  NEKTAR("nek_allshapes_p4_p6", "u", 6),
  { "nek_found_hexchannel_gll_p7", "Hex_channel_m6_nodalRestart.xml",
    "Hex_channel_m6_nodalRestart.rst", "oracle.csv", "w", 7, false },
  { "nek_found_smallmesh_tet_p3", "smallmesh.xml", "smallmesh.fld", "oracle.csv", "u", 3, false },
  NEKTAR("nek_hex_aniso_p3p5p7", "u", 7),
  NEKTAR("nek_hex_dg_varp", "u", 9),
  NEKTAR("nek_hex_gll_lagrange_p6", "u", 6),
  NEKTAR("nek_homogeneous_chan", "u", 3),
  NEKTAR("nek_ns_cylinder_hexprism_p4", "u", 4),
  NEKTAR("nek_ns_cylinder_hexprism_p4", "p", 4),
  { "nek_ns_cylinder_paperscale_p3", "nek_ns_cylinder_paperscale_p3.xml",
    "nek_ns_cylinder_paperscale_p3_u.fld", "oracle.csv", "u", 3, false },
  NEKTAR("nek_ns_kovasznay_tet_p9", "u", 9),
  NEKTAR("nek_ns_kovasznay_tet_p9", "p", 9),
  NEKTAR("nek_ns_pipe_prism_tet_p3", "u", 3),
  NEKTAR("nek_ns_pipe_prism_tet_p3", "p", 3),
  NEKTAR("nek_ns_prismhex_p3", "p", 3),
  NEKTAR("nek_prism_curved_p7", "u", 7),
  NEKTAR("nek_pyramid_curved_p6", "u", 6),
  NEKTAR("nek_tet_varp", "u", 5),
#undef NEKTAR
};

/// Several elements are parts of one of the solver's, so that reference points are not compared.
TEST(NativeOracles, NurbsAreMet)
{
  for (const NativeCase& c : {
         NativeCase{
           "mfem_nurbs_disc", "mfem_nurbs_disc.mesh", "u.gf", "oracle_u.csv", "u", 12, false },
         NativeCase{
           "mfem_nurbs_pipe", "mfem_nurbs_pipe.mesh", "u.gf", "oracle_u.csv", "u", 12, false },
         NativeCase{
           "mfem_nurbs_pipe", "mfem_nurbs_pipe.mesh", "h.gf", "oracle_h.csv", "h", 3, false },
       })
  {
    const auto reader = MakeReader(c);
    vtkNew<Messages> messages;
    messages->Watch(reader);
    reader->SetFileName(InFolder(c, c.mesh).c_str());
    reader->Update();
    ASSERT_EQ(messages->errors, "");
    OracleErrors errors;
    MeasureValues(reader->GetHighOrderOutput(), ReadOracle(InFolder(c, c.oracle)), c.field, errors);
    PrintErrors(std::string(c.folder) + " " + c.field, errors);
    EXPECT_EQ(errors.outside, 0);
    EXPECT_EQ(errors.otherElement, 0);
    EXPECT_LE(errors.value, 1e-12);
    EXPECT_LE(errors.gradient, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, NativeOracles, ::testing::ValuesIn(kNativeCases),
  [](const auto& test) { return std::string(test.param.folder) + "_" + test.param.field; });
} // namespace
