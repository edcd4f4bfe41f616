// SPDX-License-Identifier: BSD-3-Clause
#include "Window.h"

#include "Core/Base/Error.h"
#include "Views/VtkCamera.h"

#include "vtkTransform.h"

#include <limits>
#include <random>

namespace pixelexact
{
namespace
{
constexpr int kWidth = 320;
constexpr int kHeight = 200;

/// The largest sine of the angle between our rays and VTK's, and the largest distance of VTK's
/// starting point from our ray, over some pixels.
struct Deviation
{
  double angle = 0.0;
  double distance = 0.0;
};

Deviation Compare(const Camera& camera, vtkCamera* vtk, vtkMatrix4x4* dataToWorld = nullptr)
{
  Deviation worst;
  const testing::VtkRays rays(vtk, kWidth, kHeight);
  for (const auto& [px, py] :
    { std::array{ 0.5, 0.5 }, { 160.0, 100.0 }, { 319.5, 0.5 }, { 0.0, 200.0 }, { 77.5, 131.5 } })
  {
    Ray ray = camera.At(px, py);
    if (dataToWorld != nullptr)
    {
      const auto move = [&](const Vec3& x, double w)
      {
        const double in[4] = { x.x, x.y, x.z, w };
        double out[4];
        dataToWorld->MultiplyPoint(in, out);
        return Vec3(out[0], out[1], out[2]);
      };
      ray = { move(ray.origin, 1.0), glm::normalize(move(ray.direction, 0.0)) };
    }
    const Ray expected = rays.At(px, py);
    worst.angle = std::max(worst.angle, glm::length(ray.direction - expected.direction));
    const Vec3 apart = expected.origin - ray.origin;
    worst.distance =
      std::max(worst.distance, glm::length(apart - glm::dot(apart, ray.direction) * ray.direction));
  }
  return worst;
}

vtkSmartPointer<vtkCamera> RandomCamera(std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(number(random), number(random), 5.0 + number(random));
  camera->SetFocalPoint(number(random), number(random), number(random) - 2.0);
  camera->SetViewUp(number(random), 3.0, number(random));
  camera->SetParallelProjection(number(random) > 0.0);
  camera->SetParallelScale(3.0 + number(random));
  camera->SetViewAngle(40.0 + 10.0 * number(random));
  camera->SetUseHorizontalViewAngle(number(random) > 0.0);
  camera->SetWindowCenter(0.2 * number(random), 0.2 * number(random));
  camera->SetClippingRange(0.5, 20.0);
  return camera;
}
} // namespace

TEST(VtkCamera, PlainCamerasHaveVtksRays)
{
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i)
  {
    const auto camera = RandomCamera(random);
    ASSERT_TRUE(IsPlain(camera));
    const CameraSetup setup = SetupOf(camera, kWidth, kHeight);
    ASSERT_TRUE(std::holds_alternative<CameraView>(setup.rays));
    const Deviation worst = Compare(setup.Make(), camera);
    ASSERT_LT(worst.angle, 1e-13) << i;
    ASSERT_LT(worst.distance, 1e-12) << i;
  }
}

TEST(VtkCamera, RaysDependOnTheViewAlone)
{
  std::mt19937 random(2);
  const auto camera = RandomCamera(random);
  const CameraSetup setup = SetupOf(camera, kWidth, kHeight);
  camera->SetClippingRange(2.0, 3.0);
  EXPECT_TRUE(setup == SetupOf(camera, kWidth, kHeight));
  EXPECT_TRUE(setup == SetupOf(camera, kWidth, kHeight, 1.6));
  EXPECT_FALSE(setup == SetupOf(camera, kWidth + 1, kHeight));
  camera->Azimuth(1.0);
  EXPECT_FALSE(setup == SetupOf(camera, kWidth, kHeight));
}

TEST(VtkCamera, ACameraHoldsWhatItHolds)
{
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i)
  {
    const auto camera = RandomCamera(random);
    CameraView view = ViewOf(camera);
    view.viewUp *= 1.7;
    vtkNew<vtkCamera> first;
    ApplyView(view, first);
    const CameraSetup held{ AsHeld(view), kWidth, kHeight };
    ASSERT_TRUE(held == SetupOf(first, kWidth, kHeight));
    // ViewOfBox is ready for a camera.
    const Box3 box{ { -1.0, 2.0, 0.5 }, { 3.0, 2.5, 7.0 } };
    const CameraView whole = ViewOfBox(box, view.position, kWidth, kHeight, { 1.0, 2.0, 3.0 });
    vtkNew<vtkCamera> second;
    second->SetPosition(whole.position.x, whole.position.y, whole.position.z);
    second->SetFocalPoint(whole.focalPoint.x, whole.focalPoint.y, whole.focalPoint.z);
    second->SetViewUp(1.0, 2.0, 3.0);
    second->SetParallelScale(whole.parallelScale);
    const CameraSetup expected{ whole, kWidth, kHeight };
    ASSERT_TRUE(expected == SetupOf(second, kWidth, kHeight));
  }
}

TEST(VtkCamera, ViewsOfTinyMeshesStayAsTheyAre)
{
  CameraView view;
  view.position = { 3e-40, -1e-40, 2e-40 };
  view.focalPoint = { 1e-40, 1e-40, 0.0 };
  const CameraView held = AsHeld(view);
  EXPECT_EQ(held.position, view.position);
  EXPECT_EQ(held.focalPoint, view.focalPoint);
}

TEST(VtkCamera, OtherCamerasHaveVtksRays)
{
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    const auto camera = RandomCamera(random);
    double aspect = 1.6;
    switch (i % 5)
    {
      case 0:
        camera->SetViewShear(0.2, -0.3, 1.0);
        break;
      case 1:
      {
        vtkNew<vtkTransform> user;
        user->Scale(1.0, 0.5, 1.0);
        camera->SetUserTransform(user);
        break;
      }
      case 2:
      {
        vtkNew<vtkTransform> user;
        user->RotateZ(20.0);
        user->Scale(1.0, 1.3, 0.7);
        camera->SetUserViewTransform(user);
        break;
      }
      case 3:
      {
        vtkNew<vtkMatrix4x4> projection;
        projection->DeepCopy(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
        projection->SetElement(0, 1, 0.1);
        camera->SetExplicitProjectionTransformMatrix(projection);
        camera->UseExplicitProjectionTransformMatrixOn();
        break;
      }
      default:
        camera->SetExplicitAspectRatio(2.0);
        camera->UseExplicitAspectRatioOn();
    }
    ASSERT_FALSE(IsPlain(camera));
    const Deviation worst = Compare(SetupOf(camera, kWidth, kHeight).Make(), camera);
    ASSERT_LT(worst.angle, 1e-12) << i;
    ASSERT_LT(worst.distance, 1e-11) << i;
  }
}

TEST(VtkCamera, ActorsMatricesMoveTheRays)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(0.5, 2.0);
  for (int i = 0; i < 200; ++i)
  {
    const auto camera = RandomCamera(random);
    vtkNew<vtkTransform> actor;
    actor->Translate(number(random), -number(random), number(random));
    actor->RotateWXYZ(100.0 * number(random), number(random), -number(random), 1.0);
    const bool similarity = i % 2 == 0;
    const double scale = number(random);
    actor->Scale(scale, scale, similarity ? scale : (i % 4 == 1 ? 0.3 : -scale));
    const CameraSetup setup = SetupOf(camera, kWidth, kHeight, 0.0, actor->GetMatrix());
    ASSERT_EQ(std::holds_alternative<CameraView>(setup.rays), similarity);
    const Deviation worst = Compare(setup.Make(), camera, actor->GetMatrix());
    ASSERT_LT(worst.angle, 1e-12) << i;
    ASSERT_LT(worst.distance, 1e-11) << i;
  }
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(1, 1, 0.0);
  vtkNew<vtkCamera> camera;
  EXPECT_THROW((void)SetupOf(camera, kWidth, kHeight, 0.0, flat), Error);
}

TEST(VtkCamera, FramesABoxAsResetCameraDoes)
{
  const Box3 box{ { -1.0, 2.0, 0.5 }, { 3.0, 2.5, 7.0 } };
  const double bounds[6] = { -1.0, 3.0, 2.0, 2.5, 0.5, 7.0 };
  for (const bool parallel : { false, true })
  {
    for (const auto& [width, height] : { std::array{ 320, 200 }, std::array{ 200, 320 } })
    {
      for (const Vec3& towards : { Vec3(0.0, 0.0, 1.0), Vec3(1.0, -2.0, 0.5), Vec3(0.0, 3.0, 0.0) })
      {
        // Without a window the renderer has the aspect that was set.
        vtkNew<vtkRenderer> renderer;
        renderer->SetAspect(static_cast<double>(width) / height, 1.0);
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->SetFocalPoint(0.0, 0.0, 0.0);
        camera->SetPosition(towards.x, towards.y, towards.z);
        camera->SetParallelProjection(parallel);
        renderer->ResetCamera(bounds);
        const CameraView view = ViewOfBox(box, towards, width, height, { 0, 1, 0 }, parallel);
        const CameraView expected = ViewOf(camera);
        EXPECT_LT(glm::length(view.position - expected.position), 1e-12);
        EXPECT_LT(glm::length(view.focalPoint - expected.focalPoint), 1e-12);
        EXPECT_LT(glm::length(view.viewUp - expected.viewUp), 1e-12);
        EXPECT_NEAR(view.parallelScale, expected.parallelScale, 1e-12);
        EXPECT_EQ(view.parallel, parallel);
      }
    }
  }
  EXPECT_THROW((void)ViewOfBox(box, Vec3(0.0), 10, 10), Error);
  EXPECT_THROW((void)ViewOfBox({ Vec3(1.0), Vec3(-1.0) }, Vec3(1.0), 10, 10), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)ViewOfBox(box, Vec3(nan, 0.0, 1.0), 10, 10), Error);
}

TEST(VtkCamera, NonsenseIsRefused)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  const CameraSetup setup = SetupOf(camera, kWidth, kHeight);
  EXPECT_THROW((void)setup.Make(), Error);
  EXPECT_FALSE(setup == setup);
}
} // namespace pixelexact
