// SPDX-License-Identifier: BSD-3-Clause
// Extremes on cuts and faces: closed forms on cubes, and dense samples of bent meshes.
#include "CurvedMeshes.h"
#include "IntegralCheck.h"

#include "Core/Faces/FaceTable.h"
#include "Core/Integral/SurfaceExtremes.h"
#include "Core/Location/Sample.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

namespace pixelexact::testing
{
namespace
{
/// A field of a polynomial of xi, random from element to element.
struct NoisyField
{
  NoisyField(const Mesh& mesh, int order, std::uint64_t seed)
    : values(1)
  {
    Random random(seed);
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      const std::array<double, 4> a{ random(), random(), random(), random() };
      values.Add(UniformSpace(mesh.ShapeOf(e), order),
        [&](const LongVec3& xi, long double* v) {
          *v = a[0] * xi[0] + a[1] * xi[1] * xi[2] + a[2] * xi[2] * xi[2] + a[3] * xi[0] * xi[1];
        });
    }
    field.name = "u";
    field.values = values.View();
  }
  ExpansionBuilder values;
  Field field;
};

void CheckEnds(const Extremes& found)
{
  EXPECT_LE(found.minimum.bound, found.minimum.attained);
  EXPECT_GE(found.maximum.bound, found.maximum.attained);
  EXPECT_LE(found.minimum.bound, found.minimum.value);
  EXPECT_GE(found.maximum.bound, found.maximum.value);
  EXPECT_NEAR(found.minimum.value, found.minimum.attained, 1e-6);
  EXPECT_NEAR(found.maximum.value, found.maximum.attained, 1e-6);
}

/// Samples of a field on a plane, z = c, as the locator finds them.
void CheckAgainstSamples(const Mesh& mesh, const Field& field, double c)
{
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const PolynomialSurface plane(PlaneForm({ 0.0, 0.0, 1.0 }, -c));
  const SurfaceExtremes found = FindExtremesOnCut({ mesh, &field, &plane }, 0, locator, faces);
  EXPECT_TRUE(found.extremes.met);
  CheckEnds(found.extremes);
  std::vector<Vec3> points;
  constexpr int kSide = 300;
  for (int i = 0; i <= kSide; ++i)
  {
    for (int j = 0; j <= kSide; ++j)
    {
      points.emplace_back(2.8 * i / kSide - 1.4, 2.8 * j / kSide - 1.4, c);
    }
  }
  std::vector<double> values(points.size());
  std::vector<Verdict> verdicts(points.size());
  SampleTarget target{};
  target.verdict = verdicts;
  target.value = values;
  Sample(locator, &field, points, target);
  double low = INFINITY;
  double high = -INFINITY;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    if (verdicts[k] == Verdict::Inside)
    {
      low = std::min(low, values[k]);
      high = std::max(high, values[k]);
    }
  }
  EXPECT_GE(low, found.extremes.minimum.bound - 1e-13);
  EXPECT_LE(high, found.extremes.maximum.bound + 1e-13);
  // Samples are near the extremes: the field is smooth, and the grid fine.
  EXPECT_NEAR(low, found.extremes.minimum.value, 0.2);
  EXPECT_NEAR(high, found.extremes.maximum.value, 0.2);
  EXPECT_NEAR(found.extremes.minimum.x.z, c, 1e-7);
  EXPECT_NEAR(found.extremes.maximum.x.z, c, 1e-7);
}
} // namespace

TEST(SurfaceExtremes, OnAPlaneThroughACube)
{
  MeshBuilder builder = Cube();
  const Mesh mesh = builder.View();
  ExpansionBuilder values(1);
  // Its maximum on z = 0.25 is 3 - 2 (0.25)^2 at (0.3, -0.4); the minimum is at a corner.
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& x, long double* v)
    {
      *v =
        3.0L - (x[0] - 0.3L) * (x[0] - 0.3L) - (x[1] + 0.4L) * (x[1] + 0.4L) - 2.0L * x[2] * x[2];
    });
  Field field;
  field.name = "u";
  field.values = values.View();
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const PolynomialSurface plane(PlaneForm({ 0.0, 0.0, 2.0 }, -0.5));
  const IntegralQuestion question{ mesh, &field, &plane };
  const Extremes found = FindExtremesOnCut(question, 0, locator, faces).extremes;
  EXPECT_TRUE(found.met);
  CheckEnds(found);
  EXPECT_LE(found.maximum.attained, 2.875);
  EXPECT_GE(found.maximum.bound, 2.875);
  EXPECT_LT(found.maximum.gap, 5e-6);
  EXPECT_NEAR(found.maximum.x.x, 0.3, 2e-3);
  EXPECT_NEAR(found.maximum.x.y, -0.4, 2e-3);
  const double lowest = 2.875 - 1.3 * 1.3 - 1.4 * 1.4;
  EXPECT_LE(found.minimum.bound, lowest + 1e-14);
  EXPECT_GE(found.minimum.attained, lowest - 1e-14);
  EXPECT_NEAR(found.minimum.x.x, -1.0, 1e-12);
  EXPECT_NEAR(found.minimum.x.y, 1.0, 1e-12);
  // Clipped to x <= 0: the maximum is on the rim.
  const std::array clips{ PlaneForm({ 1.0, 0.0, 0.0 }, 0.0) };
  IntegralQuestion clipped = question;
  clipped.clips = clips;
  const Extremes part = FindExtremesOnCut(clipped, 0, locator, faces).extremes;
  EXPECT_LE(part.maximum.attained, 2.875 - 0.09 + 1e-14);
  EXPECT_GE(part.maximum.bound, 2.875 - 0.09 - 1e-14);
  EXPECT_LT(part.maximum.gap, 1e-5);
  EXPECT_LE(part.maximum.x.x, 1e-12);
}

TEST(SurfaceExtremes, OfAMagnitudeOnASphere)
{
  MeshBuilder builder = Cube();
  const Mesh mesh = builder.View();
  ExpansionBuilder values(3);
  values.Add(UniformSpace(Shape::Hexahedron, 1),
    [](const LongVec3& x, long double* v)
    {
      v[0] = x[0];
      v[1] = x[1] + 1.0L;
      v[2] = x[2];
    });
  Field field;
  field.name = "v";
  field.values = values.View();
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  ImplicitPolynomial ball;
  ball.a.q = { 4.0, 4.0, 4.0, 0, 0, 0 };
  ball.a.c = -1.0;
  const PolynomialSurface sphere(ball);
  // The distance from (0, -1, 0) of a sphere of radius 1/2: 0.5 to 1.5.
  const Extremes found =
    FindExtremesOnCut({ mesh, &field, &sphere }, FieldFunction::kNorm, locator, faces).extremes;
  CheckEnds(found);
  EXPECT_LE(found.minimum.bound, 0.5);
  EXPECT_GE(found.minimum.attained, 0.5);
  EXPECT_LE(found.maximum.attained, 1.5);
  EXPECT_GE(found.maximum.bound, 1.5);
  EXPECT_NEAR(found.maximum.x.y, 0.5, 1e-2);
  EXPECT_LT(found.maximum.gap, 1e-3);
}

TEST(SurfaceExtremes, HoldSamplesOfBentMeshes)
{
  for (const std::span<const Shape> shapes :
    { std::span<const Shape>(kHexahedra), std::span<const Shape>(kPrisms),
      std::span<const Shape>(kTetrahedra), std::span<const Shape>(kMixed) })
  {
    const CurvedMesh made = Blocks(2, shapes);
    const Mesh mesh = made.View();
    const NoisyField noisy(mesh, 3, 11);
    CheckAgainstSamples(mesh, noisy.field, 0.123);
  }
}

TEST(SurfaceExtremes, OnFacesOfACube)
{
  MeshBuilder builder = Cube();
  const Mesh mesh = builder.View();
  ExpansionBuilder values(1);
  // 1 inside, at the centre of a face 0, at corners -2.
  values.Add(UniformSpace(Shape::Hexahedron, 2),
    [](const LongVec3& x, long double* v) { *v = 1.0L - x[0] * x[0] - x[1] * x[1] - x[2] * x[2]; });
  Field field;
  field.name = "u";
  field.values = values.View();
  std::vector<ElementFace> faces;
  for (int f = 0; f < 6; ++f)
  {
    faces.push_back({ 0, f });
  }
  const SurfaceExtremes found = FindExtremesOnFaces({ mesh, &field, nullptr }, 0, faces);
  EXPECT_EQ(found.faces, 6);
  CheckEnds(found.extremes);
  EXPECT_LE(found.extremes.maximum.attained, 1e-14);
  EXPECT_GE(found.extremes.maximum.bound, -1e-14);
  EXPECT_LT(found.extremes.maximum.gap, 3e-6);
  EXPECT_LE(found.extremes.minimum.bound, -2.0 + 1e-14);
  EXPECT_GE(found.extremes.minimum.attained, -2.0 - 1e-14);
}

TEST(SurfaceExtremes, ThreadsChangeNothing)
{
  const CurvedMesh made = Blocks(2, kMixed);
  const Mesh mesh = made.View();
  const NoisyField noisy(mesh, 2, 5);
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  const PolynomialSurface plane(PlaneForm({ 1.0, 0.5, 0.25 }, -0.1));
  std::vector<double> found;
  for (const std::size_t threads : { 1, 4 })
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Extremes ends =
      FindExtremesOnCut({ mesh, &noisy.field, &plane }, 0, locator, faces).extremes;
    found.insert(found.end(),
      { ends.minimum.bound, ends.minimum.attained, ends.minimum.x.x, ends.maximum.value });
  }
  EXPECT_TRUE(std::equal(found.begin(), found.begin() + 4, found.begin() + 4));
}
} // namespace pixelexact::testing
