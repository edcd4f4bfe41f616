// SPDX-License-Identifier: BSD-3-Clause
// Solvers' files against values, gradients and world points that the solvers' own libraries
// computed at given reference points.
#include "Support.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkHighOrderProbe.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct Case
{
  const char* grid;
  const char* oracle;
  const char* field;
  int order;         ///< of the nodes
  bool unitElements; ///< the oracle's r, s, t are on the unit elements, ours up to scale
};

std::ostream& operator<<(std::ostream& os, const Case& c)
{
  return os << c.grid;
}

/// The largest sum of |cardinal functions| of n + 1 equispaced nodes: what the rounding of nodal
/// values may grow to.
double Lebesgue(int n)
{
  double largest = 1.0;
  for (int i = 0; i < 40 * n; ++i)
  {
    const double z = (i + 0.5) / 40.0;
    double sum = 0.0;
    for (int k = 0; k <= n; ++k)
    {
      double cardinal = 1.0;
      for (int m = 0; m <= n; ++m)
      {
        cardinal *= m == k ? 1.0 : (z - m) / (k - m);
      }
      sum += std::fabs(cardinal);
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

class Oracles : public ::testing::TestWithParam<Case>
{
protected:
  static std::filesystem::path Find(const std::string& file)
  {
    const std::filesystem::path own = std::filesystem::path(PIXELEXACT_DATA_DIR) / file;
    return std::filesystem::exists(own) ? own
                                        : std::filesystem::path(PIXELEXACT_SHARED_DATA_DIR) / file;
  }
};

TEST_P(Oracles, AreMet)
{
  const Case c = GetParam();
  if (!std::filesystem::exists(Find(c.grid)))
  {
    GTEST_SKIP() << c.grid << " is not on this machine";
  }
  const Table table = ReadTable(Find(c.oracle));
  Conversion conversion(ReadGrid(Find(c.grid)));
  ASSERT_TRUE(conversion.done) << conversion.messages->errors;
  EXPECT_EQ(conversion.messages->warnings, "");
  vtkHighOrderGrid* grid = conversion.Output();

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto& x = table.at("x");
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    points->InsertNextPoint(x[i], table.at("y")[i], table.at("z")[i]);
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(points);
  vtkNew<vtkHighOrderProbe> probe;
  probe->SetInputData(where);
  probe->SetSourceData(grid);
  probe->AddField(c.field);
  probe->ComputeGradientsOn();
  probe->Update();
  vtkPointData* found = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData();

  // Rounding of the nodal values and some of the evaluation; at usual orders the limit that the
  // project promises.
  const double share = c.order <= 6 ? 1e-13 : 10 * std::pow(Lebesgue(c.order), 3) * 1.2e-16;
  const double valueTolerance = std::max(1e-11, share);
  const double gradientTolerance = std::max(1e-8, share * c.order * c.order);

  vtkDataArray* values = found->GetArray(c.field);
  vtkDataArray* gradients = found->GetArray((std::string(c.field) + "_Gradient").c_str());
  ASSERT_NE(values, nullptr);
  const int components = values->GetNumberOfComponents();
  // MFEM and DOLFINx: the value column is called u whatever the field.
  const auto column = [&](int k)
  {
    const std::string name = components > 1 ? "u" + std::to_string(k) : "u";
    return table.contains(c.field) ? table.at(c.field) : table.at(name);
  };
  vtkDataArray* sizes = grid->GetFieldData()->GetArray("PixelExact.Mesh.Size");
  double worst[3] = { 0.0, 0.0, 0.0 }; // value, gradient, point
  for (int k = 0; k < components; ++k)
  {
    const auto expected = column(k);
    const auto [low, high] = std::ranges::minmax(expected);
    const double range = high - low;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const auto at = static_cast<vtkIdType>(i);
      ASSERT_EQ(found->GetArray("Verdict")->GetComponent(at, 0), 1.0) << "point " << i;
      const auto element = static_cast<vtkIdType>(found->GetArray("Element")->GetComponent(at, 0));
      const double error = std::fabs(values->GetComponent(at, k) - expected[i]) / range;
      ASSERT_FALSE(std::isnan(error)) << "point " << i;
      worst[0] = std::max(worst[0], error);
      for (int d = 0; table.contains("dudx") && d < 3; ++d)
      {
        const double slope = table.at(std::string("dud") + "xyz"[d])[i];
        const double difference = std::fabs(gradients->GetComponent(at, 3 * k + d) - slope);
        worst[1] = std::max(worst[1], difference * sizes->GetComponent(element, 0) / range);
      }
    }
  }
  if (c.unitElements)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const auto element = static_cast<vtkIdType>(table.at("element")[i]);
      const double r = table.at("r")[i];
      const double s = table.at("s")[i];
      const double t = table.at("t")[i];
      const bool wedge =
        grid->GetFieldData()->GetArray("PixelExact.Mesh.Spaces")->GetComponent(0, 0) == 1.0;
      const double xi[3] = { 2 * r - 1, wedge ? 1 - 2 * t : 2 * s - 1,
        wedge ? 2 * s - 1 : 2 * t - 1 };
      double y[3];
      ASSERT_TRUE(grid->MapForward(element, xi, y));
      for (int d = 0; d < 3; ++d)
      {
        worst[2] = std::max(worst[2],
          std::fabs(y[d] - points->GetPoint(static_cast<vtkIdType>(i))[d]) /
            sizes->GetComponent(element, 0));
      }
    }
  }
  std::printf("[ measured ] %-55s value %.1e gradient %.1e point %.1e\n", c.grid, worst[0],
    worst[1], worst[2]);
  EXPECT_LE(worst[0], valueTolerance);
  EXPECT_LE(worst[1], gradientTolerance);
  EXPECT_LE(worst[2], std::max(1e-13, share));
}

const Case kCases[] = {
  { "toroid_hex_g3_p6.vtu", "toroid_hex_g3_p6.oracle.csv", "u", 6, true },
  { "escher_tet_g3_p3.vtu", "escher_tet_g3_p3.oracle.csv", "u", 3, true },
  { "toroid_prism_g3_p4.vtu", "toroid_prism_g3_p4.oracle.csv", "u", 4, true },
  { "fichera_hex_g3_p4.vtu", "fichera_hex_g3_p4.oracle.csv", "u", 4, true },
  { "periodic_hex_dg_g3_p4.vtu", "periodic_hex_dg_g3_p4.oracle.csv", "u", 4, true },
  { "dolfinx_hex_g2_p4.vtu", "dolfinx_hex_g2_p4.oracle.csv", "u", 4, true },
#define SHARED(name, file, oracle) name "/" file, name "/" oracle
  { SHARED("dolfinx_hex_g2_p4", "dolfinx_hex_g2_p4.vtu", "oracle_u.csv"), "u", 4, true },
  { SHARED("dolfinx_tet_g3_p3", "dolfinx_tet_g3_p3.vtu", "oracle_u.csv"), "u", 3, true },
  { SHARED("glvis_laghos_hex_g2_dg", "glvis_laghos_hex_g2_dg.vtu", "oracle_e.csv"), "e", 2, true },
  { SHARED("mfem_beam_hex_elast_p4", "mfem_beam_hex_elast_p4.vtu", "oracle_displacement.csv"),
    "displacement", 4, true },
  { SHARED("mfem_escher_tet_21k_p3", "mfem_escher_tet_21k_p3_zlib.vtu", "oracle_u.csv"), "u", 3,
    true },
  { SHARED("mfem_escher_tet_darcy_p3", "mfem_escher_tet_darcy_p3.vtu", "oracle_pressure.csv"),
    "pressure", 3, true },
  { SHARED("mfem_escher_tet_p3", "mfem_escher_tet_p3.vtu", "oracle_u.csv"), "u", 3, true },
  { SHARED("mfem_escher_tet_p8", "mfem_escher_tet_p8.vtu", "oracle_u.csv"), "u", 8, true },
  { SHARED("mfem_fichera_hex_amr_g3_p3", "mfem_fichera_hex_amr_g3_p3.vtu", "oracle_u.csv"), "u", 3,
    true },
  { SHARED("mfem_fichera_hex_g3_p4", "mfem_fichera_hex_g3_p4.vtu", "oracle_u.csv"), "u", 4, true },
  { SHARED("mfem_periodic_hex_dg_g3_p4", "mfem_periodic_hex_dg_g3_p4.vtu", "oracle_u.csv"), "u", 4,
    true },
  { SHARED("mfem_toroid_hex_g3_p16", "mfem_toroid_hex_g3_p16.vtu", "oracle_u.csv"), "u", 16, true },
  { SHARED("mfem_toroid_hex_g3_p6", "mfem_toroid_hex_g3_p6.vtu", "oracle_u.csv"), "u", 6, true },
  { SHARED("mfem_toroid_prism_g3_p4", "mfem_toroid_prism_g3_p4_vtkwedge.vtu", "oracle_u.csv"), "u",
    4, true },
  { SHARED("nek_ns_kovasznay_tet_p9", "nek_ns_kovasznay_tet_p9_ho.vtu", "oracle.csv"), "u", 9,
    false },
  { SHARED("nek_ns_kovasznay_tet_p9", "nek_ns_kovasznay_tet_p9_ho.vtu", "oracle.csv"), "p", 9,
    false },
  { SHARED("nek_prism_curved_p7", "nek_prism_curved_p7_ho.vtu", "oracle.csv"), "u", 7, false },
#undef SHARED
};

INSTANTIATE_TEST_SUITE_P(Files, Oracles, ::testing::ValuesIn(kCases),
  [](const auto& test)
  {
    std::string name =
      std::filesystem::path(test.param.grid).stem().string() + "_" + test.param.field;
    return std::to_string(test.index) + "_" + name;
  });
} // namespace
