// SPDX-License-Identifier: BSD-3-Clause
// Location against brute force on real meshes: Newton from many starts in every element whose box
// holds the point, without frames, injectivity or subdivision.
#include "HighOrderModel.h"
#include "Support.h"

#include "Core/Location/ElementBounds.h"
#include "Core/Location/Sample.h"

#include <tbb/parallel_for.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
using namespace pixelexact;
using namespace pixelexact::testing;

/// Starts along each direction of the tensor cube.
constexpr int kStarts = 4;

/// Whether some start leads to a root of the element, within its faces' tolerance.
bool HoldsByBruteForce(const Mesh& mesh, int element, const Vec3& x)
{
  const ElementBounds bounds = MakeElementBounds(mesh, element);
  InverseProblem problem = MakeInverseProblem(mesh, element, bounds);
  problem.guess = nullptr;
  std::fill_n(problem.inverse, 9, 0.0);
  problem.affine = false;
  const auto kernels = KernelsFor(problem.space);
  double lanes[9][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, x[d]);
  }
  const InverseResult result{ { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], lanes[8] };
  for (int start = 0; start < kStarts * kStarts * kStarts; ++start)
  {
    const auto at = [](int i) { return (2.0 * i + 1.0) / kStarts - 1.0; };
    const Vec3 eta(
      at(start % kStarts), at(start / kStarts % kStarts), at(start / kStarts / kStarts));
    const Vec3 xi = TensorToReference(problem.space.shape, eta);
    for (int d = 0; d < 3; ++d)
    {
      problem.start[d] = xi[d];
    }
    kernels.invert(problem, { { lanes[0], lanes[1], lanes[2] }, 1 }, result);
    if (lanes[6][0] == static_cast<double>(NewtonStatus::RootInside))
    {
      return true;
    }
  }
  return false;
}

/// Points all over the mesh's box, and points a little inside and outside of faces.
std::vector<Vec3> Points(const Mesh& mesh, const Box3& bounds)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 t(
      0.5 * (uniform(random) + 1.0), 0.5 * (uniform(random) + 1.0), 0.5 * (uniform(random) + 1.0));
    points.push_back(bounds.lower + t * (bounds.upper - bounds.lower));
  }
  for (double distance = 1e-10; distance < 0.5; distance *= 10.0)
  {
    for (int i = 0; i < 200; ++i)
    {
      const auto element = static_cast<int>(random() % static_cast<unsigned>(mesh.Elements()));
      Vec3 eta(uniform(random), uniform(random), uniform(random));
      const auto direction = static_cast<int>(random() % 3U);
      eta[direction] = random() % 2U == 0 ? -1.0 - distance : 1.0 + distance;
      const Vec3 xi = TensorToReference(mesh.ShapeOf(element), eta);
      Vec3 x;
      MapForward(mesh, element, { &xi, 1 }, { &x, 1 });
      points.push_back(x);
    }
  }
  return points;
}

class BruteForce : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BruteForce, AgreesOnInsideAndOutside)
{
  const auto grid = Converted(ReadGrid(std::filesystem::path(PIXELEXACT_DATA_DIR) / GetParam()));
  const auto model = HighOrderModel::From(grid);
  const Mesh& mesh = model->GetMesh();
  const Locator& locator = model->GetLocator();
  const auto points = Points(mesh, locator.Bounds());
  std::vector<Verdict> verdict(points.size());
  std::vector<std::int32_t> element(points.size());
  std::vector<Vec3> xi(points.size());
  SampleTarget target;
  target.verdict = verdict;
  target.element = element;
  target.xi = xi;
  Sample(locator, nullptr, points, target);

  std::vector<int> found(points.size(), -1);
  tbb::parallel_for(std::size_t{ 0 }, points.size(),
    [&](std::size_t i)
    {
      for (int e = 0; e < mesh.Elements() && found[i] < 0; ++e)
      {
        if (locator.ElementBox(e).Contains(points[i]) && HoldsByBruteForce(mesh, e, points[i]))
        {
          found[i] = e;
        }
      }
    });
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NE(verdict[i], Verdict::Unknown) << i;
    EXPECT_EQ(verdict[i] == Verdict::Inside, found[i] >= 0) << "point " << i;
    EXPECT_EQ(element[i], found[i]) << "point " << i;
    if (verdict[i] == Verdict::Inside)
    {
      ++inside;
      Vec3 x;
      MapForward(mesh, element[i], { &xi[i], 1 }, { &x, 1 });
      const double error = std::max({ std::fabs(x.x - points[i].x), std::fabs(x.y - points[i].y),
        std::fabs(x.z - points[i].z) });
      EXPECT_LT(error, 1e-13 * mesh.size[static_cast<std::size_t>(element[i])]);
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, static_cast<int>(points.size()));
}

INSTANTIATE_TEST_SUITE_P(Data, BruteForce,
  ::testing::Values("toroid_hex_g3_p6.vtu", "escher_tet_g3_p3.vtu", "toroid_prism_g3_p4.vtu",
    "fichera_hex_g3_p4.vtu", "periodic_hex_dg_g3_p4.vtu", "dolfinx_hex_g2_p4.vtu"),
  [](const auto& file)
  {
    std::string name = file.param;
    return name.substr(0, name.find('.'));
  });
} // namespace
