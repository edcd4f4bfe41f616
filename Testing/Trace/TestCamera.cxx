// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Camera.h"
#include "Trace/TraceTile.h"

#include "Core/Base/Error.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pixelexact::testing
{
namespace
{
void ExpectNear(const Vec3& a, const Vec3& b, double tolerance = 1e-15)
{
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

CameraView Straight()
{
  CameraView view;
  view.position = { 0.0, 0.0, 5.0 };
  view.viewAngle = 90.0;
  return view;
}

/// The four columns of a matrix, as rows of an array.
std::array<double, 16> FromColumns(const Vec3& a, double aw, const Vec3& b, double bw,
  const Vec3& c, double cw, const Vec3& d, double dw)
{
  return { a.x, b.x, c.x, d.x, a.y, b.y, c.y, d.y, a.z, b.z, c.z, d.z, aw, bw, cw, dw };
}
} // namespace

TEST(Camera, PerspectiveRaysPassThroughTheirPixels)
{
  const Camera camera(Straight(), 200, 100);
  const Ray centre = camera.At(100.0, 50.0);
  ExpectNear(centre.origin, { 0.0, 0.0, 5.0 });
  ExpectNear(centre.direction, { 0.0, 0.0, -1.0 });
  // 90 degrees: the upper edge's ray rises as fast as it goes forward; the image is twice as wide.
  const Ray corner = camera.At(200.0, 100.0);
  ExpectNear(corner.direction, glm::normalize(Vec3(2.0, 1.0, -1.0)));
  EXPECT_NEAR(glm::length(corner.direction), 1.0, 1e-15);
}

TEST(Camera, ParallelRaysShareTheirDirection)
{
  CameraView view = Straight();
  view.parallel = true;
  view.parallelScale = 3.0;
  const Camera camera(view, 200, 100);
  const Ray corner = camera.At(200.0, 0.0);
  ExpectNear(corner.origin, { 6.0, -3.0, 5.0 });
  ExpectNear(corner.direction, { 0.0, 0.0, -1.0 });
  ExpectNear(camera.ViewDirection(), { 0.0, 0.0, -1.0 });
}

TEST(Camera, WindowCentreShiftsTheImage)
{
  CameraView view = Straight();
  view.parallel = true;
  view.windowCenter = { 1.0, 0.0 };
  // The view covers [0, 2] of the half-widths then.
  ExpectNear(Camera(view, 100, 100).At(0.0, 50.0).origin, { 0.0, 0.0, 5.0 });
}

TEST(Camera, FromMatrixAgreesWithTheView)
{
  // NDC to world of a camera at (0,0,5) looking down, 90 degrees, near 1, far 11:
  // w_eye = 1 / depth interpolates linearly in z: 1/w = (a z + b).
  const double nearPlane = 1.0;
  const double farPlane = 11.0;
  const double a = (1.0 / farPlane - 1.0 / nearPlane) / 2.0;
  const double b = (1.0 / farPlane + 1.0 / nearPlane) / 2.0;
  // Homogeneous world point: (2u, v, -1, 0) + (0, 0, 5, 1) (a z + b).
  const auto perspective = FromColumns({ 2.0, 0.0, 0.0 }, 0.0, { 0.0, 1.0, 0.0 }, 0.0,
    { 0.0, 0.0, 5.0 * a }, a, { 0.0, 0.0, -1.0 + 5.0 * b }, b);
  const Camera fromMatrix(perspective, 200, 100);
  const Camera fromView(Straight(), 200, 100);
  for (const double px : { 0.0, 37.5, 200.0 })
  {
    for (const double py : { 0.0, 62.5, 100.0 })
    {
      ExpectNear(fromMatrix.At(px, py).direction, fromView.At(px, py).direction, 1e-14);
      ExpectNear(fromMatrix.At(px, py).origin, fromView.At(px, py).origin, 1e-14);
    }
  }
  const auto parallel = FromColumns({ 2.0, 0.0, 0.0 }, 0.0, { 0.0, 1.0, 0.0 }, 0.0,
    { 0.0, 0.0, -4.0 }, 0.0, { 0.0, 0.0, 0.0 }, 1.0);
  const Camera flat(parallel, 200, 100);
  ExpectNear(flat.At(200.0, 100.0).origin, { 2.0, 1.0, 4.0 });
  ExpectNear(flat.At(0.0, 0.0).direction, { 0.0, 0.0, -1.0 });
}

TEST(Camera, RefusesWhatIsNoCamera)
{
  CameraView view = Straight();
  EXPECT_THROW(Camera(view, 0, 10), Error);
  view.focalPoint = view.position;
  EXPECT_THROW(Camera(view, 10, 10), Error);
  view = Straight();
  view.viewUp = { 0.0, 0.0, 2.0 };
  EXPECT_THROW(Camera(view, 10, 10), Error);
  view = Straight();
  view.viewAngle = 180.0;
  EXPECT_THROW(Camera(view, 10, 10), Error);
  view = Straight();
  view.position.x = std::nan("");
  EXPECT_THROW(Camera(view, 10, 10), Error);
  view = Straight();
  view.parallel = true;
  view.parallelScale = 0.0;
  EXPECT_THROW(Camera(view, 10, 10), Error);
  std::array<double, 16> zero{};
  EXPECT_THROW(Camera(zero, 10, 10), Error);
}

namespace
{
/// A surface that records its rays.
class Listening final : public Surface
{
public:
  void Meet(const RayLanes& rays, HitSlots& /*hits*/) const override
  {
    for (int i = 0; i < rays.count; ++i)
    {
      Rays.push_back({ { rays.origin[0][i], rays.origin[1][i], rays.origin[2][i] },
        { rays.direction[0][i], rays.direction[1][i], rays.direction[2][i] } });
      EXPECT_EQ(rays.tNear[i], kNearest);
      EXPECT_EQ(rays.tFar[i], kFarthest);
    }
  }
  [[nodiscard]] Vec3 Normal(const SurfacePoint& /*point*/) const override { return Vec3(1.0); }

  mutable std::vector<Ray> Rays;
};
} // namespace

/// The tiles' rays are bitwise those of the camera.
TEST(TileSamples, RaysAreTheCamerasBitForBit)
{
  CameraView view = Straight();
  view.position = { 0.3, -0.2, 5.0 };
  view.focalPoint = { 0.1, 0.4, -0.7 };
  for (const bool parallel : { false, true })
  {
    view.parallel = parallel;
    const Camera camera(view, 77, 53);
    TileSamples samples;
    samples.Begin(camera, { 64, 32, 77, 53 }, {}, 77);
    const auto surface = std::make_shared<Listening>();
    Scene scene;
    scene.layers.push_back({ surface });
    std::vector<HitSlots> hits;
    samples.Meet(camera, scene, hits);
    ASSERT_EQ(surface->Rays.size(), 13U * 21U);
    for (std::size_t k = 0; k < surface->Rays.size(); ++k)
    {
      const auto place = static_cast<int>(samples.place[k]);
      const Ray ray = camera.At(place % 77 + 0.5, place / 77 + 0.5);
      EXPECT_EQ(surface->Rays[k].origin, ray.origin);
      EXPECT_EQ(surface->Rays[k].direction, ray.direction);
    }
  }
}
} // namespace pixelexact::testing
