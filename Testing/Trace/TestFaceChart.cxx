// SPDX-License-Identifier: BSD-3-Clause
// What is known of elements' faces before rays come near them: their xi, and boxes.
#include "CurvedCheck.h"

#include "Core/Location/Sample.h"
#include "Trace/Surfaces/Curved/FaceChart.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pixelexact::testing
{
namespace
{
/// The point of a face where the two other eta are s and t.
Vec3 OnFace(Shape shape, const ShapeFace& face, double s, double t)
{
  Vec3 eta;
  eta[face.direction] = face.upper ? 1.0 : -1.0;
  eta[face.direction == 0 ? 1 : 0] = s;
  eta[face.direction == 2 ? 1 : 2] = t;
  return TensorToReference(shape, eta);
}
} // namespace

TEST(FaceChart, HoldsTheFacesPoints)
{
  Random random(3);
  for (const Shape shape : kShapes)
  {
    const auto faces = FacesOf(shape);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      SCOPED_TRACE(Name(shape) + std::string(", face ") + std::to_string(f));
      const FaceChart chart = ChartOf(shape, static_cast<int>(f));
      ASSERT_EQ(chart.across, faces[f].direction);
      for (int k = 0; k < 50; ++k)
      {
        const Vec3 xi = OnFace(shape, faces[f], random(), random());
        EXPECT_NEAR(xi[chart.across],
          chart.constant + chart.along[0] * xi[chart.free[0]] + chart.along[1] * xi[chart.free[1]],
          1e-15);
      }
      // Where nothing collapses, u ends at 1 for each v.
      const double end = OnFace(shape, faces[f], 1.0, 0.5)[chart.free[0]];
      EXPECT_EQ(chart.collapses, end < 1.0);
      EXPECT_NEAR(end, chart.collapses ? -0.5 : 1.0, 1e-15);
    }
  }
}

TEST(FaceBox, HoldsTheFaceAndLittleMore)
{
  Random random(4);
  for (const Shape shape : kShapes)
  {
    MeshBuilder mesh;
    mesh.Add(UniformSpace(shape, 3), Curved);
    const auto faces = FacesOf(shape);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      SCOPED_TRACE(Name(shape) + std::string(", face ") + std::to_string(f));
      const CurvedPart part{ 0, static_cast<std::int32_t>(f) };
      const auto modes = FaceRestriction().Of(mesh.View(), part);
      ASSERT_TRUE(modes.has_value());
      std::vector<Vec3> xi;
      for (int i = -20; i <= 20; ++i)
      {
        for (int j = -20; j <= 20; ++j)
        {
          xi.push_back(OnFace(shape, faces[f], 0.05 * i, 0.05 * j));
        }
      }
      std::vector<Vec3> x(xi.size());
      MapForward(mesh.View(), 0, xi, x);
      Box3 seen{ x[0], x[0] };
      for (const Vec3& one : x)
      {
        seen = { glm::min(seen.lower, one), glm::max(seen.upper, one) };
      }
      for (const FaceModes* of : { &*modes, static_cast<const FaceModes*>(nullptr) })
      {
        const Box3 box = FaceBox(mesh.View(), part, of);
        for (int d = 0; d < 3; ++d)
        {
          EXPECT_LE(box.lower[d], seen.lower[d]);
          EXPECT_GE(box.upper[d], seen.upper[d]);
          EXPECT_LT(box.upper[d] - box.lower[d], 2.0 * (seen.upper[d] - seen.lower[d]) + 0.5);
        }
      }
    }
  }
}
} // namespace pixelexact::testing
