// SPDX-License-Identifier: BSD-3-Clause
// Faces as triangles: linear fields on flat faces come back exactly, and areas add up.
#include "Block.h"

#include "Core/Shape/ShapeFace.h"
#include "Trace/Compare/LinearFaces.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace pixelexact::testing
{
TEST(LinearFaces, LinearFieldsOnFlatFacesLoseNothing)
{
  Block block;
  const Mesh& mesh = block.scene_.locator->GetMesh();
  // The faces at z = 1, whose elements are bent along it.
  std::vector<ElementFace> faces;
  for (int element = 4; element < 8; ++element)
  {
    faces.push_back({ element, 5 });
  }
  // Odd, so that no ray goes along a seam, whose two sides are rounded apart.
  constexpr int kWidth = 61;
  constexpr int kHeight = 48;
  const Camera camera = ViewAlongZ(kWidth, kHeight);
  for (const int parts : { 1, 3, 8 })
  {
    const LinearSurface surface = TrianglesOfFaces(mesh, block.field_, 0, faces, parts);
    EXPECT_EQ(surface.Count(), static_cast<std::size_t>(4 * 2 * parts * parts));
    EXPECT_EQ(surface.Count(), CountTriangles(mesh, faces, parts));
    const std::vector<double> values = surface.Trace(camera, false);
    int seen = 0;
    for (int k = 0; k < kWidth * kHeight; ++k)
    {
      const Vec3 x = camera.At(k % kWidth + 0.5, k / kWidth + 0.5).origin;
      const double beyond = std::max(std::fabs(x.x), std::fabs(x.y)) - 1.0;
      const double value = values[static_cast<std::size_t>(k)];
      ASSERT_EQ(std::isnan(value), beyond > 0.0) << k;
      if (beyond < 0.0)
      {
        ASSERT_NEAR(value, x.x + 10.0 * x.y + 100.0, 1e-12) << k;
        ++seen;
      }
    }
    EXPECT_GT(seen, 1000);
  }
}

TEST(LinearFaces, FacesOfEachShapeAreCoveredOnce)
{
  for (const Shape shape : kShapes)
  {
    MeshBuilder builder;
    ExpansionBuilder values(1);
    const Space space = UniformSpace(shape, 1);
    builder.Add(space, [](const LongVec3& xi) { return xi; });
    values.Add(space, [](const LongVec3& xi, long double* u) { u[0] = xi[0] - xi[1] + 2 * xi[2]; });
    const Mesh mesh = builder.View();
    const Field field{ "u", values.View() };
    const auto count = static_cast<int>(FacesOf(shape).size());
    for (int face = 0; face < count; ++face)
    {
      const std::array<ElementFace, 1> one{ ElementFace{ 0, face } };
      const LinearSurface coarse = TrianglesOfFaces(mesh, field, 0, one, 1);
      const LinearSurface fine = TrianglesOfFaces(mesh, field, 0, one, 5);
      ASSERT_EQ(fine.Count(), 25 * coarse.Count());
      // Slantwise, so that no face is seen along itself.
      CameraView view;
      view.position = { 7.0, 5.0, 3.0 };
      view.parallel = true;
      view.parallelScale = 2.0;
      const Camera camera(view, 90, 90);
      const std::vector<double> a = coarse.Trace(camera, false);
      const std::vector<double> b = fine.Trace(camera, false);
      int seen = 0;
      for (std::size_t k = 0; k < a.size(); ++k)
      {
        ASSERT_EQ(std::isnan(a[k]), std::isnan(b[k])) << k;
        if (!std::isnan(a[k]))
        {
          ASSERT_NEAR(a[k], b[k], 1e-12);
          ++seen;
        }
      }
      EXPECT_GT(seen, 50) << Name(shape) << " face " << face;
    }
  }
}
} // namespace pixelexact::testing
