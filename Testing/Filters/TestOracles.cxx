// SPDX-License-Identifier: BSD-3-Clause
// Values at VTK's nodes, as solvers write them, against the solvers' own libraries.
#include "InstructionSets.h"
#include "OracleCheck.h"

#include <span>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

struct GridCase
{
  const char* grid;
  const char* oracle;
  const char* field;
  int order;         ///< of the nodes
  bool unitElements; ///< the oracle's r, s, t are on the unit elements, ours up to scale
};

std::ostream& operator<<(std::ostream& os, const GridCase& c)
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

void CheckOracle(const GridCase& c)
{
  const Table table = ReadOracle(FindData(c.oracle));
  Conversion conversion(ReadGrid(FindData(c.grid)));
  ASSERT_TRUE(conversion.done) << conversion.messages->errors;
  EXPECT_EQ(conversion.messages->warnings, "");

  // Rounding of the nodal values and some of the evaluation; at usual orders the limit that the
  // project promises.
  const double share = c.order <= 6 ? 1e-13 : 10 * std::pow(Lebesgue(c.order), 3) * 1.2e-16;
  OracleErrors errors;
  MeasureValues(conversion.Output(), table, c.field, errors);
  if (c.unitElements)
  {
    MeasurePoints(conversion.Output(), table, errors);
  }
  PrintErrors(c.grid, errors);
  EXPECT_EQ(errors.outside, 0);
  EXPECT_LE(errors.value, std::max(1e-11, share));
  EXPECT_LE(errors.gradient, std::max(1e-8, share * c.order * c.order));
  EXPECT_LE(errors.point, std::max(1e-13, share));
}

class Oracles : public ::testing::TestWithParam<GridCase>
{
};

TEST_P(Oracles, AreMet)
{
  if (!std::filesystem::exists(FindData(GetParam().grid)))
  {
    GTEST_SKIP() << GetParam().grid << " is not on this machine";
  }
  CheckOracle(GetParam());
}

const GridCase kGridCases[] = {
  // The project's own.
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

TEST(OraclesOfData, AreMetOnEveryInstructionSet)
{
  constexpr std::size_t kOwn = 6;
  OnEveryInstructionSet(
    [&]
    {
      for (const GridCase& c : std::span(kGridCases).first(kOwn))
      {
        CheckOracle(c);
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Files, Oracles, ::testing::ValuesIn(kGridCases),
  [](const auto& test)
  {
    std::string name =
      std::filesystem::path(test.param.grid).stem().string() + "_" + test.param.field;
    return std::to_string(test.index) + "_" + name;
  });
} // namespace
