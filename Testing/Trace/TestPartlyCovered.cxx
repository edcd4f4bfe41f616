// SPDX-License-Identifier: BSD-3-Clause
// A face of which another element covers a part: in closed form.
#include "HitBatch.h"
#include "TwoBlocks.h"

#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/ElementFaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// The boundary of two blocks, from their table of faces.
ElementFaces MakeBoundary(const TwoBlocks& blocks)
{
  std::vector<ElementFace> faces;
  std::vector<bool> partly;
  for (int e = 0; e < 2; ++e)
  {
    for (int f = 0; f < static_cast<int>(FacesOf(Shape::Hexahedron).size()); ++f)
    {
      const FaceKind kind = blocks.Table->KindOf(e, f);
      if (kind == FaceKind::Boundary || kind == FaceKind::Partly)
      {
        faces.push_back({ e, f });
        partly.push_back(kind == FaceKind::Partly);
      }
    }
  }
  return { *blocks.locator_, faces, partly };
}
} // namespace

TEST(PartlyCovered, WhatIsCoveredIsNotThere)
{
  for (const bool swapped : { false, true })
  {
    const TwoBlocks blocks(0.5, {}, swapped);
    ASSERT_EQ(blocks.Table->CountOf(FaceKind::Partly), 1);
    const ElementFaces boundary = MakeBoundary(blocks);
    Random random(11);
    std::vector<Ray> rays;
    for (int i = 0; i < 400; ++i)
    {
      rays.push_back(TwoBlocks::RayAt(random(-0.99, 0.99), random(-0.99, 0.99)));
    }
    const auto all = MeetPoints(boundary, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const double y = rays[i].origin.y;
      const double z = rays[i].origin.z;
      const bool covered = std::fabs(y) < 0.5 && std::fabs(z) < 0.5;
      // The ray enters at x = g - 1, and leaves at the end of the second block, or of the first.
      ASSERT_EQ(all[i].size(), 2U) << y << ' ' << z;
      const double between = static_cast<double>(TwoBlocks::Between(y, z));
      EXPECT_NEAR(all[i][0].t, 2.0 + between, 1e-14);
      EXPECT_NEAR(all[i][1].t, (covered ? 4.0 : 3.0) + between, 1e-14);
      EXPECT_EQ(all[i][1].status, HitStatus::Certain);
    }
  }
}

TEST(PartlyCovered, RaysEndAtTheFirstThatIsThere)
{
  const TwoBlocks blocks(0.5, {});
  const ElementFaces boundary = MakeBoundary(blocks);
  // A ray from inside the first block, through the covered part, to the second block's end.
  const auto hits = MeetPoints(boundary, { TwoBlocks::RayAt(0.2, 0.1) }, { 2.5 }, true);
  ASSERT_FALSE(hits[0].empty());
  EXPECT_NEAR(hits[0][0].t, 4.0 + static_cast<double>(TwoBlocks::Between(0.2, 0.1)), 1e-14);
}

TEST(PartlyCovered, AlongTheRimAPointIsOnOneSide)
{
  const TwoBlocks blocks(0.5, {});
  const ElementFaces boundary = MakeBoundary(blocks);
  for (const double y : { std::nextafter(0.5, 0.0), 0.5, std::nextafter(0.5, 1.0) })
  {
    const auto hits = HitsOf(boundary, TwoBlocks::RayAt(y, 0.1));
    ASSERT_GE(hits.size(), 2U) << y;
    EXPECT_EQ(hits.front().status, HitStatus::Certain);
  }
}
} // namespace pixelexact::testing
