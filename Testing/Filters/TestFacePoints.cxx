// SPDX-License-Identifier: BSD-3-Clause
// Real meshes are watertight: points on and beside the faces, edges and vertices of their elements.
// 1e6 points of each kind on each mesh: PIXELEXACT_FACE_POINTS=1000000 TestFilters
// --gtest_filter='*FacePoints*'.
#include "Core/FaceCheck.h"
#include "LoadMesh.h"

#include "HighOrderModel.h"

#include <gtest/gtest.h>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

constexpr int kDefaultCount = 1500;

/// Next to faces: the distances from the face, of the element's size, of three points in a row.
constexpr double kRow[] = { 0.0, 1e-4, 1e-3 };

struct PointRows
{
  std::vector<Vec3> on;
  std::vector<Vec3> near;                 ///< at 1e-16 to 1e-6
  std::vector<Vec3> far[std::size(kRow)]; ///< the first is not used
};

/// A point beyond a face of the element, away from its centre.
Vec3 Beyond(LongMap& map, const Mesh& mesh, int element, const LongVec3& face, long double distance)
{
  const LongVec3 centre = ToLong(Centre(mesh.ShapeOf(element)));
  LongVec3 xi;
  for (int d = 0; d < 3; ++d)
  {
    xi[d] = face[d] + distance * (face[d] - centre[d]);
  }
  return ToDouble(map(element, xi));
}

PointRows MakePoints(const Mesh& mesh, int count)
{
  PointRows points;
  LongMap map(mesh);
  Random random(53);
  for (int i = 0; i < count; ++i)
  {
    const auto element = static_cast<int>(random(0.0, mesh.Elements()));
    const LongVec3 face = OnBoundary(random, mesh.ShapeOf(element));
    points.on.push_back(ToDouble(map(element, face)));
    points.near.push_back(Beyond(map, mesh, element, face, SmallDistance(random)));
    for (std::size_t k = 1; k < std::size(kRow); ++k)
    {
      points.far[k].push_back(Beyond(map, mesh, element, face, kRow[k]));
    }
  }
  return points;
}

class FacePoints : public ::testing::TestWithParam<const char*>
{
};

TEST_P(FacePoints, AreFoundAndNoGapIsBesideThem)
{
  const auto own = std::filesystem::path(PIXELEXACT_DATA_DIR) / GetParam();
  const auto shared = std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / GetParam();
  const auto file = std::filesystem::exists(own) ? own : shared;
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << GetParam() << " is not on this machine";
  }
  const auto grid = LoadMesh(file);
  ASSERT_NE(grid, nullptr);
  const auto model = HighOrderModel::From(grid);
  const Locator& locator = model->GetLocator();
  const PointRows points = MakePoints(model->GetMesh(), FacePointCount(kDefaultCount));

  const FaceReport on = CheckPoints(locator, points.on);
  on.Print(file.stem().string() + ", on faces");
  EXPECT_EQ(on.inside, on.points) << on.first;
  EXPECT_EQ(on.wrong, 0) << on.first;

  std::vector<Verdict> nearVerdict(points.near.size());
  const FaceReport near = CheckPoints(locator, points.near, nearVerdict);
  near.Print(file.stem().string() + ", beside faces");
  EXPECT_EQ(near.unknown, 0) << near.first;
  EXPECT_EQ(near.wrong, 0) << near.first;

  // Where the mesh goes on a little farther out, it does so at once.
  std::vector<Verdict> farVerdict[std::size(kRow)];
  for (std::size_t k = 1; k < std::size(kRow); ++k)
  {
    farVerdict[k].resize(points.far[k].size());
    const FaceReport far = CheckPoints(locator, points.far[k], farVerdict[k]);
    EXPECT_EQ(far.unknown, 0) << far.first;
    EXPECT_EQ(far.wrong, 0) << far.first;
  }
  int gaps = 0;
  for (std::size_t i = 0; i < points.near.size(); ++i)
  {
    const bool goesOn = farVerdict[1][i] == Verdict::Inside && farVerdict[2][i] == Verdict::Inside;
    gaps += goesOn && nearVerdict[i] == Verdict::Outside ? 1 : 0;
  }
  EXPECT_EQ(gaps, 0);
}

#define FOLDER(name, suffix) name "/" name suffix
const char* const kFiles[] = { "toroid_hex_g3_p6.vtu", "escher_tet_g3_p3.vtu",
  "toroid_prism_g3_p4.vtu", "fichera_hex_g3_p4.vtu", "periodic_hex_dg_g3_p4.vtu",
  "dolfinx_hex_g2_p4.vtu", FOLDER("mfem49_tinyzoo_g3_p5", ".mesh"),
  FOLDER("nek_hex_aniso_p3p5p7", ".xml"), FOLDER("nek_hex_gll_lagrange_p6", ".xml"),
  FOLDER("nek_prism_curved_p7", ".xml"), FOLDER("nek_pyramid_curved_p6", ".xml"),
  FOLDER("nek_tet_varp", ".xml"), FOLDER("dolfinx_tet_g3_p3", ".vtu"),
  FOLDER("glvis_laghos_hex_g2_dg", ".mesh"), FOLDER("mfem49_pyramid_g3_p4", ".mesh"),
  FOLDER("mfem_beam_hex_elast_p4", ".mesh"), FOLDER("mfem_escher_tet_p3", ".mesh"),
  FOLDER("mfem_fichera_hex_amr_g3_p3", ".mesh"), FOLDER("mfem_toroid_hex_g3_p6", ".mesh"),
  FOLDER("mfem_toroid_prism_g3_p4", ".mesh"), FOLDER("nek_allshapes_p4_p6", ".xml"),
  FOLDER("nek_ns_cylinder_hexprism_p4", ".xml"), FOLDER("nek_ns_kovasznay_tet_p9", ".xml"),
  FOLDER("nek_ns_pipe_prism_tet_p3", ".xml") };

INSTANTIATE_TEST_SUITE_P(Files, FacePoints, ::testing::ValuesIn(kFiles),
  [](const auto& test)
  { return std::to_string(test.index) + "_" + std::filesystem::path(test.param).stem().string(); });
} // namespace
