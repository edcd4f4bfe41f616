// SPDX-License-Identifier: BSD-3-Clause
// What surfaces that are made of elements make, and what they leave alone.
#include "Block.h"

#include "Core/Shape/ShapeFace.h"
#include "Trace/Surfaces/ElementFaces.h"
#include "Trace/Surfaces/IsoSurface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
/// Down through the middle of the element on the side x, y > 0.
const Ray kDown{ { 0.5, 0.5, 5.0 }, { 0.0, 0.0, -1.0 } };

class CurvedParts : public ::testing::Test
{
protected:
  /// x + 10 y + 100 z of `value`.
  IsoSurface Iso(double value)
  {
    return { block_.scene_.locator->Index(), block_.field_, 0, value };
  }

  Block block_;
};
} // namespace

TEST_F(CurvedParts, IsoSurfacesKeepElementsThatMayHoldTheValue)
{
  // The upper four have values from -11 to 111, the lower four from -111 to 11; the hulls of the
  // bent ones are a little wider.
  EXPECT_EQ(Iso(60.0).Parts(), 4);
  EXPECT_EQ(Iso(-60.0).Parts(), 4);
  EXPECT_EQ(Iso(0.0).Parts(), 8);
  EXPECT_EQ(Iso(60.0).PartsMade(), 0);
}

TEST_F(CurvedParts, ARayMakesThoseThatItComesNear)
{
  const IsoSurface iso = Iso(60.0);
  const auto hits = HitsOf(iso, kDown);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_NEAR(hits[0].t, 5.0 - (60.0 - 0.5 - 5.0) / 100.0, 1e-13);
  EXPECT_GE(iso.PartsMade(), 1);
  EXPECT_LT(iso.PartsMade(), 4);
  const auto pieces = iso.PiecesMade();
  EXPECT_GT(pieces, 0);
  // The same ray makes nothing more.
  EXPECT_EQ(HitsOf(iso, kDown).size(), 1U);
  EXPECT_EQ(iso.PiecesMade(), pieces);
  // A ray that misses the surface creates no parts.
  const IsoSurface other = Iso(60.0);
  EXPECT_TRUE(HitsOf(other, { { 1.5, 0.5, 5.0 }, { 0.0, 0.0, -1.0 } }).empty());
  EXPECT_EQ(other.PartsMade(), 0);
}

TEST_F(CurvedParts, OtherComponentsDoNotCount)
{
  // The second component is NaN in the first element, at x, y, z < 0; the first one is not.
  const IsoSurface iso = Iso(-60.0);
  const auto hits = HitsOf(iso, { { -0.5, -0.5, 5.0 }, { 0.0, 0.0, -1.0 } });
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_NEAR(hits[0].t, 5.0 - (-60.0 + 0.5 + 5.0) / 100.0, 1e-13);
}

TEST_F(CurvedParts, FacesOfOneElementAreMetInItsBox)
{
  // The cube's top and bottom: of the elements 4 to 7 the face xi_3 = 1, of 0 to 3 xi_3 = -1.
  std::vector<ElementFace> faces;
  for (int e = 0; e < 8; ++e)
  {
    const auto& all = FacesOf(Shape::Hexahedron);
    const auto found = std::ranges::find_if(all,
      [e](const ShapeFace& face) { return face.direction == 2 && face.upper == ((e & 4) != 0); });
    ASSERT_NE(found, all.end());
    faces.push_back({ e, static_cast<int>(found - all.begin()) });
  }
  const ElementFaces surface(block_.scene_.locator->Index(), faces);
  EXPECT_EQ(surface.Parts(), 8);
  const auto hits = HitsOf(surface, kDown);
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_NEAR(hits[0].t, 4.0, 1e-14);
  EXPECT_NEAR(hits[1].t, 6.0, 1e-14);
  EXPECT_LT(surface.PartsMade(), 8);
}
} // namespace pixelexact::testing
