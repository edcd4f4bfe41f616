// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FacePlane.h"
#include "Core/Shape/ShapeFace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pixelexact::testing
{
TEST(FacePlane, IsTheFaceThatHasItsNumber)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> inCube(-1.0, 1.0);
  for (int s = 0; s < kShapeCount; ++s)
  {
    const auto shape = static_cast<Shape>(s);
    const auto faces = FacesOf(shape);
    const auto planes = FacePlanesOf(shape);
    ASSERT_EQ(faces.size(),
      shape == Shape::Hexahedron      ? 6U
        : shape == Shape::Tetrahedron ? 4U
                                      : 5U);
    ASSERT_EQ(planes.size(), faces.size()) << Name(shape);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      double widest = 0.0;
      for (int i = 0; i < 100; ++i)
      {
        Vec3 eta(inCube(random), inCube(random), inCube(random));
        const double within = planes[f].Distance(TensorToReference(shape, eta));
        EXPECT_GT(within, 0.0);
        widest = std::max(widest, within);
        eta[faces[f].direction] = faces[f].upper ? 1.0 : -1.0;
        EXPECT_NEAR(planes[f].Distance(TensorToReference(shape, eta)), 0.0, 1e-15) << f;
      }
      EXPECT_LE(widest, 2.0);
    }
  }
}

TEST(FacePlane, LeavesMargin)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> around(-1.5, 1.5);
  for (int s = 0; s < kShapeCount; ++s)
  {
    const auto shape = static_cast<Shape>(s);
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 xi(around(random), around(random), around(random));
      double least = 10.0;
      for (const FacePlane& plane : FacePlanesOf(shape))
      {
        least = std::min(least, plane.Distance(xi));
      }
      EXPECT_NEAR(least, Margin(shape, xi), 1e-15) << Name(shape);
    }
  }
}
} // namespace pixelexact::testing
