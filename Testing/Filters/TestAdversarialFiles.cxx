// SPDX-License-Identifier: BSD-3-Clause
// Files of single elements made to break location's proofs, with the truth in 50 digits. They two
// were written by the first version of the data set: its fingerprints are honoured.
#include "Support.h"

#include "Core/Location/Owners.h"
#include "Core/Location/Sample.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "LongMap.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
class AdversarialFiles : public ::testing::Test
{
protected:
  void Load(const std::string& name)
  {
    const auto folder = std::filesystem::path(PIXELEXACT_DATA_DIR) / "adversarial";
    Grid = ReadGrid(folder / (name + ".vtu"));
    ASSERT_NE(Grid, nullptr);
    if (!HasHighOrderArrays(Grid))
    {
      Grid = Converted(Grid);
    }
    Model = HighOrderModel::From(Grid);
    const auto table = ReadTable(folder / (name + ".points.csv"));
    for (std::size_t i = 0; i < table.at("x").size(); ++i)
    {
      Points.emplace_back(table.at("x")[i], table.at("y")[i], table.at("z")[i]);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::shared_ptr<const HighOrderModel> Model;
  std::vector<Vec3> Points;
};
} // namespace

TEST_F(AdversarialFiles, APointIsNotPutWhereThePinchedMapDoesNotTakeIt)
{
  Load("pinched_hexahedron");
  Verdict verdict = Verdict::Unknown;
  Vec3 xi(0.0);
  SampleTarget target;
  target.verdict = std::span(&verdict, 1);
  target.xi = std::span(&xi, 1);
  SampleTile(Model->GetLocator(), nullptr, Points, target);
  // Around xi_0 = -9.8e-7 x is 0.6 xi_0^3 up to 1e-13: what is within 1e-4 is a preimage in
  // doubles.
  if (verdict == Verdict::Inside)
  {
    EXPECT_LT(std::fabs(xi.x + 9.75391066354776e-7), 1e-4);
    EXPECT_NEAR(xi.y, 0.0979695941017861, 1e-9);
    EXPECT_NEAR(xi.z, -0.106741792062286, 1e-9);
    // The tolerance of `inside`: four uncertainties, and one for the rounding of stored values.
    const Mesh& mesh = Model->GetMesh();
    const LongVec3 image = LongMap(mesh)(0, ToLong(xi));
    const ElementBounds bounds = MakeElementBounds(mesh, 0);
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_LE(std::fabs(static_cast<double>(image[d] - Points[0][d])),
        (kMaxMiss + 1.0) * bounds.uncertainty[d] * mesh.size[0])
        << d;
    }
  }
  else
  {
    EXPECT_EQ(verdict, Verdict::Unknown);
  }
}

TEST_F(AdversarialFiles, ThePointBesideTheApexHasOnePreimage)
{
  Load("apex_pyramid");
  Owners owners;
  FindOwners(Model->GetLocator(), Points, std::span(&owners, 1));
  EXPECT_EQ(owners.coverage, Coverage::Once);
  EXPECT_EQ(owners.preimages, 1);
  Vec3 xi(0.0);
  SampleTarget target;
  target.xi = std::span(&xi, 1);
  SampleTile(Model->GetLocator(), nullptr, Points, target);
  EXPECT_NEAR(xi.x, -0.99999999998185515814, 1e-14);
  EXPECT_NEAR(xi.y, -0.99999999997584993571, 1e-14);
  EXPECT_NEAR(xi.z, 0.99999999997442911872, 1e-14);
}

TEST_F(AdversarialFiles, WhatIsKnownOfAPointDoesNotDependOnTheOthers)
{
  Load("collapsed_hexahedron");
  const auto ask = [this](std::span<const Vec3> points)
  {
    std::vector<Verdict> verdict(points.size());
    SampleTarget target;
    target.verdict = verdict;
    const Locator locator(Model->GetMesh());
    Sample(locator, nullptr, points, target);
    return verdict;
  };
  const auto forward = ask(Points);
  std::ranges::reverse(Points);
  auto backward = ask(Points);
  std::ranges::reverse(backward);
  EXPECT_EQ(forward, backward);
}

TEST_F(AdversarialFiles, PointsBesideACollapsedEdgeAreDecided)
{
  Load("collapsed_hexahedron");
  std::vector<Verdict> verdict(Points.size());
  SampleTarget target;
  target.verdict = verdict;
  Sample(Model->GetLocator(), nullptr, Points, target);
  int unknown = 0;
  for (std::size_t i = 0; i < Points.size(); ++i)
  {
    const double x = Points[i].x;
    const double y = std::fabs(Points[i].y);
    // x = (1 + xi_0) / 2, y = (1 + xi_0) xi_1 / 2: on the edge a point has no xi of its own.
    constexpr double kRounding = 1e-14;
    if (verdict[i] == Verdict::Inside)
    {
      EXPECT_LE(y, x + kRounding) << i;
    }
    else if (verdict[i] == Verdict::Outside)
    {
      EXPECT_GE(y, x - kRounding) << i;
    }
    else if (x != 0.0 || y != 0.0)
    {
      ++unknown;
      EXPECT_LT(std::max(x, y), 1e-10) << i;
    }
  }
  EXPECT_LT(unknown, 30);
}
} // namespace pixelexact::testing
