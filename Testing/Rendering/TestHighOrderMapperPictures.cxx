// SPDX-License-Identifier: BSD-3-Clause
#include "CutScene.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkPlaneSource.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <tuple>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Rgb;
using testing::Window;

} // namespace

class HighOrderMapperPicture : public ::testing::TestWithParam<std::tuple<bool, int>>
{
};

TEST_P(HighOrderMapperPicture, GeometryHidesAndIsHidden)
{
  const auto [parallel, multiSamples] = GetParam();
  for (const bool cutFirst : { true, false })
  {
    CutScene scene;
    Window window(multiSamples);
    window.Renderer->AddActor(cutFirst ? scene.Cut : scene.Sphere);
    window.Renderer->AddActor(cutFirst ? scene.Sphere : scene.Cut);
    CutScene::Look(window.Renderer, parallel);
    window.Render();
    CutScene::ExpectPicture(window, Window::kWhole);
    EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, HighOrderMapperPicture, ::testing::Combine(::testing::Bool(), ::testing::Values(0, 8)));

TEST(HighOrderMapper, SubViewport)
{
  CutScene scene;
  Window window;
  window.Renderer->SetViewport(0.25, 0.2, 0.85, 0.9);
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(scene.Sphere);
  CutScene::Look(window.Renderer, false);
  window.Render();
  CutScene::ExpectPicture(window, { 80, 48, 192, 168 });
  int size[3];
  scene.Mapper->GetBuffers()->GetDimensions(size);
  EXPECT_EQ(size[0], 192);
  EXPECT_EQ(size[1], 168);
}

TEST(HighOrderMapper, TranslucentGeometryInFront)
{
  for (const bool peeling : { false, true })
  {
    CutScene scene;
    Window window;
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-5.0, -5.0, 0.9);
    source->SetPoint1(5.0, -5.0, 0.9);
    source->SetPoint2(-5.0, 5.0, 0.9);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> glass;
    glass->SetMapper(mapper);
    glass->GetProperty()->SetColor(0.0, 1.0, 0.0);
    glass->GetProperty()->SetOpacity(0.4);
    glass->GetProperty()->LightingOff();
    window.Renderer->AddActor(glass);
    window.Renderer->AddActor(scene.Cut);
    window.Renderer->AddActor(scene.Sphere);
    window.Renderer->SetUseDepthPeeling(peeling);
    window.RenderWindow->SetAlphaBitPlanes(1);
    CutScene::Look(window.Renderer, false);
    window.Render();
    CutScene::ExpectPicture(
      window, Window::kWhole,
      [](const Rgb& behind)
      {
        Rgb color{};
        for (int c = 0; c < 3; ++c)
        {
          color[c] = static_cast<int>(std::lround(0.6 * behind[c] + (c == 1 ? 0.4 * 255 : 0.0)));
        }
        return color;
      },
      false);
  }
}

TEST(HighOrderMapper, OpacityLetsThroughWhatIsBehind)
{
  for (const bool peeling : { false, true })
  {
    CutScene scene;
    Window window;
    scene.Cut->GetProperty()->SetOpacity(0.5);
    window.Renderer->AddActor(scene.Cut);
    window.Renderer->AddActor(scene.Sphere);
    window.Renderer->SetUseDepthPeeling(peeling);
    window.RenderWindow->SetAlphaBitPlanes(1);
    vtkCamera* camera = window.Renderer->GetActiveCamera();
    CutScene::Look(window.Renderer, false);
    window.Render();
    const testing::VtkRays rays(camera, Window::kWidth, Window::kHeight);
    int through = 0;
    for (int j = 0; j < Window::kHeight; ++j)
    {
      for (int i = 0; i < Window::kWidth; ++i)
      {
        const Ray ray = rays.At(i + 0.5, j + 0.5);
        const CutScene::Expected first = CutScene::Meet(ray);
        if (first.seen != CutScene::Seen::Cut ||
          std::max(std::abs(first.position.x), std::abs(first.position.y)) > 0.98)
        {
          continue;
        }
        const Vec3 o = ray.origin - CutScene::kCentre;
        const double b = glm::dot(o, ray.direction);
        const double discriminant = b * b - glm::dot(o, o) + CutScene::kRadius * CutScene::kRadius;
        if (std::abs(discriminant) < 0.02)
        {
          continue; // the sphere's outline
        }
        const bool sphere = discriminant > 0.0;
        through += sphere ? 1 : 0;
        const int gray = CutScene::Gray(first.position);
        const Rgb behind = sphere ? Rgb{ 255, 0, 0 } : Window::kBackground;
        const Rgb drawn = window.Color(i, j);
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(drawn[c], 0.5 * gray + 0.5 * behind[c], 3)
            << i << ", " << j << " channel " << c << (peeling ? " peeling" : "");
        }
      }
    }
    EXPECT_GT(through, 100);
  }
}

TEST(HighOrderMapper, ActorsMatrixMovesCutAndField)
{
  for (const bool similarity : { true, false })
  {
    CutScene scene;
    Window window;
    scene.Cut->SetPosition(0.3, -0.2, 0.1);
    scene.Cut->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
    scene.Cut->SetScale(0.7, similarity ? 0.7 : 0.4, 0.7);
    window.Renderer->AddActor(scene.Cut);
    CutScene::Look(window.Renderer, false);
    window.Render();
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(scene.Cut->GetMatrix(), inverse);
    const auto move = [](vtkMatrix4x4* matrix, const Vec3& x, double w)
    {
      const double in[4] = { x.x, x.y, x.z, w };
      double out[4];
      matrix->MultiplyPoint(in, out);
      return Vec3(out[0], out[1], out[2]);
    };
    vtkCamera* camera = window.Renderer->GetActiveCamera();
    const testing::VtkRays rays(camera, Window::kWidth, Window::kHeight);
    int cut = 0;
    for (int j = 0; j < Window::kHeight; ++j)
    {
      for (int i = 0; i < Window::kWidth; ++i)
      {
        const Ray world = rays.At(i + 0.5, j + 0.5);
        const Ray ray{ move(inverse, world.origin, 1.0), move(inverse, world.direction, 0.0) };
        const Vec3 x = ray.origin - ray.origin.z / ray.direction.z * ray.direction;
        const double distance = 1.0 - std::max(std::abs(x.x), std::abs(x.y));
        if (std::abs(distance) < 1e-9)
        {
          continue;
        }
        Rgb color = Window::kBackground;
        double depth = 1.0;
        if (distance > 0.0)
        {
          ++cut;
          color.fill(CutScene::Gray(x));
          depth = testing::VtkDepth(
            camera, move(scene.Cut->GetMatrix(), x, 1.0), Window::kWidth, Window::kHeight);
        }
        const Rgb drawn = window.Color(i, j);
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(drawn[c], color[c], 1) << i << ", " << j;
        }
        ASSERT_NEAR(window.Depth(i, j), depth, 3e-7) << i << ", " << j;
      }
    }
    EXPECT_GT(cut, 3000);
  }
}

TEST(HighOrderMapper, OneMapperInTwoWindows)
{
  CutScene scene;
  for (int i = 0; i < 2; ++i)
  {
    Window first;
    Window second;
    for (Window* window : { &first, &second })
    {
      window->Renderer->AddActor(scene.Cut);
      window->Renderer->AddActor(scene.Sphere);
      CutScene::Look(window->Renderer, i == 0);
    }
    for (Window* window : { &first, &second, &first })
    {
      window->Render();
      CutScene::ExpectPicture(*window, Window::kWhole);
    }
    first.RenderWindow->Finalize();
    second.Render();
    CutScene::ExpectPicture(second, Window::kWhole);
    // Each window has its frame.
    EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 2 * (i + 1));
  }
}
} // namespace pixelexact
