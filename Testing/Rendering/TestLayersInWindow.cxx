// SPDX-License-Identifier: BSD-3-Clause
// Lit and translucent layers among ordinary geometry, in real windows.
#include "CutScene.h"

#include "vtkHighOrderLayer.h"
#include "vtkImageData.h"
#include "vtkImplicitTorus.h"
#include "vtkLight.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSphere.h"

#include <functional>

namespace pixelexact
{
namespace
{
using testing::CutScene;
using testing::Rgb;
using testing::VtkRays;
using testing::Window;

constexpr double kRadius = 0.8;

/// A sphere within the mesh, by rays and by triangles.
struct TwoSpheres
{
  TwoSpheres()
  {
    Function->SetRadius(kRadius);
    Scene.Mapper->SetCutFunction(Function);
    Scene.Mapper->ScalarVisibilityOff();
    Scene.Source->SetCenter(0.0, 0.0, 0.0);
    Scene.Source->SetRadius(kRadius);
    for (vtkActor* actor : { Scene.Cut.Get(), Scene.Sphere.Get() })
    {
      actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
      actor->GetProperty()->LightingOn();
    }
    Scene.Sphere->GetProperty()->SetInterpolationToPhong();
  }

  /// Both pictures of the renderer's lights and camera, alike but for outlines.
  void Compare(const std::function<void(vtkRenderer*)>& prepare, bool parallel)
  {
    std::vector<Rgb> colors[2];
    for (const int which : { 0, 1 })
    {
      Window window;
      window.Renderer->AddActor(which == 0 ? Scene.Cut : Scene.Sphere);
      prepare(window.Renderer);
      CutScene::Look(window.Renderer, parallel);
      window.Render();
      for (int j = 0; j < Window::kHeight; ++j)
      {
        for (int i = 0; i < Window::kWidth; ++i)
        {
          colors[which].push_back(window.Color(i, j));
        }
      }
    }
    int compared = 0;
    int lit = 0;
    for (int j = 2; j < Window::kHeight - 2; ++j)
    {
      for (int i = 2; i < Window::kWidth - 2; ++i)
      {
        const auto at = [&](int which, int dx, int dy)
        { return colors[which][static_cast<std::size_t>((j + dy) * Window::kWidth + i + dx)]; };
        bool inner = true;
        for (int d = 0; d < 25; ++d)
        {
          inner = inner && at(1, d % 5 - 2, d / 5 - 2) != Window::kBackground;
        }
        if (!inner)
        {
          continue;
        }
        ++compared;
        lit += at(0, 0, 0)[0] > 60 ? 1 : 0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          // Normals of triangles are nearly those of the sphere.
          ASSERT_NEAR(at(0, 0, 0)[c], at(1, 0, 0)[c], 2) << i << ", " << j;
        }
      }
    }
    EXPECT_GT(compared, 2000);
    EXPECT_GT(lit, 200);
  }

  CutScene Scene;
  vtkNew<vtkSphere> Function;
};

void AddLight(vtkRenderer* renderer, const std::function<void(vtkLight*)>& prepare)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(2.0, -2.0, 3.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  prepare(light);
  renderer->AddLight(light);
}
} // namespace

TEST(LayersInWindow, LightIsThatOfVtksPolygons)
{
  for (const bool parallel : { false, true })
  {
    TwoSpheres spheres;
    spheres.Compare([](vtkRenderer*) {}, parallel);
    for (vtkActor* actor : { spheres.Scene.Cut.Get(), spheres.Scene.Sphere.Get() })
    {
      actor->GetProperty()->SetAmbient(0.1);
      actor->GetProperty()->SetDiffuse(0.7);
      actor->GetProperty()->SetSpecular(0.4);
      actor->GetProperty()->SetSpecularPower(12.0);
      actor->GetProperty()->SetSpecularColor(0.8, 1.0, 0.9);
    }
    spheres.Compare([](vtkRenderer*) {}, parallel);
    const auto directional = [](vtkRenderer* renderer)
    {
      AddLight(renderer,
        [](vtkLight* light)
        {
          light->SetDiffuseColor(1.0, 0.7, 0.4);
          light->SetIntensity(0.9);
        });
      AddLight(renderer,
        [](vtkLight* light)
        {
          light->SetPosition(-3.0, -1.0, 0.5);
          light->SetDiffuseColor(0.1, 0.3, 0.6);
        });
      AddLight(renderer, [](vtkLight* light) { light->SwitchOff(); });
    };
    spheres.Compare(directional, parallel);
    const auto positional = [](vtkRenderer* renderer)
    {
      AddLight(renderer,
        [](vtkLight* light)
        {
          light->PositionalOn();
          light->SetConeAngle(25.0);
          light->SetExponent(3.0);
          light->SetAttenuationValues(0.4, 0.1, 0.05);
        });
      vtkNew<vtkLight> atCamera;
      atCamera->SetLightTypeToCameraLight();
      atCamera->SetPosition(0.5, 0.5, 1.0);
      atCamera->SetFocalPoint(0.0, 0.0, 0.0);
      atCamera->SetIntensity(0.3);
      renderer->AddLight(atCamera);
    };
    spheres.Compare(positional, parallel);
    // Normals follow the actor's matrix.
    for (vtkActor* actor : { spheres.Scene.Cut.Get(), spheres.Scene.Sphere.Get() })
    {
      actor->SetScale(1.1, 0.7, 0.9);
      actor->RotateWXYZ(35.0, 1.0, 2.0, 0.5);
    }
    spheres.Compare(directional, parallel);
  }
}

TEST(LayersInWindow, RecolouringAndRelightingTraceNothing)
{
  CutScene scene;
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.7);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(sphere);
  layer->SetOpacity(0.5);
  scene.Mapper->AddLayer(layer);
  Window window;
  window.Renderer->AddActor(scene.Cut);
  vtkNew<vtkLight> light;
  window.Renderer->AddLight(light);
  CutScene::Look(window.Renderer, false);
  window.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 1);
  const Rgb before = window.Color(160, 120);
  int colorings = 1;
  const auto expectRecoloured = [&]
  {
    window.Render();
    EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 1);
    EXPECT_EQ(scene.Mapper->GetNumberOfColorings(), ++colorings);
  };
  light->SetIntensity(0.5);
  expectRecoloured();
  EXPECT_NE(window.Color(160, 120), before);
  scene.Cut->GetProperty()->SetSpecular(0.6);
  expectRecoloured();
  layer->SetOpacity(0.3);
  expectRecoloured();
  layer->ScalarVisibilityOff();
  expectRecoloured();
  layer->SetColor(0.2, 0.4, 0.6);
  expectRecoloured();
  layer->LightingOff();
  expectRecoloured();
  scene.Mapper->SetScalarRange(0.0, 1.0);
  layer->ScalarVisibilityOn();
  expectRecoloured();
  // Opacity does not affect which surfaces rays meet.
  layer->SetOpacity(1.0);
  window.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 2);
  layer->VisibilityOff();
  window.Render();
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 3);
}

/// A translucent sphere of PixelExact about a red one of VTK's, which hides its back, over a plane
/// of PixelExact, compared with a ray tracer of six lines.
TEST(LayersInWindow, TranslucentLayersBeforeAndBehindOpaqueGeometry)
{
  CutScene scene;
  vtkNew<vtkSphere> glass;
  glass->SetRadius(0.9);
  vtkNew<vtkHighOrderLayer> layer;
  layer->SetCutFunction(glass);
  layer->ScalarVisibilityOff();
  layer->SetColor(0.0, 1.0, 0.0);
  layer->SetOpacity(0.4);
  layer->LightingOff();
  scene.Mapper->AddLayer(layer);
  Window window;
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(scene.Sphere);
  window.Renderer->SetUseDepthPeeling(true);
  window.Renderer->SetMaximumNumberOfPeels(8);
  window.RenderWindow->SetAlphaBitPlanes(1);
  CutScene::Look(window.Renderer, false);
  window.Render();
  const VtkRays rays(window.Renderer->GetActiveCamera(), Window::kWidth, Window::kHeight);
  // The number of translucent walls in front of the visible object.
  const auto seen = [&](double x, double y)
  {
    const Ray ray = rays.At(x, y);
    const CutScene::Expected behind = CutScene::Meet(ray);
    const double end = behind.seen == CutScene::Seen::Nothing
      ? 1e9
      : glm::dot(behind.position - ray.origin, ray.direction);
    const double b = glm::dot(ray.origin, ray.direction);
    const double square = b * b - glm::dot(ray.origin, ray.origin) + 0.81;
    int walls = 0;
    for (const double side : { -1.0, 1.0 })
    {
      walls += square > 0.0 && -b + side * std::sqrt(square) < end ? 1 : 0;
    }
    return std::pair(behind, walls);
  };
  int count[3] = {};
  for (int j = 1; j < Window::kHeight - 1; ++j)
  {
    for (int i = 1; i < Window::kWidth - 1; ++i)
    {
      const auto [behind, walls] = seen(i + 0.5, j + 0.5);
      bool edge = false;
      for (const auto& [dx, dy] : { std::pair(-1, 0), { 1, 0 }, { 0, -1 }, { 0, 1 } })
      {
        const auto [other, otherWalls] = seen(i + 0.5 + dx, j + 0.5 + dy);
        edge = edge || other.seen != behind.seen || otherWalls != walls;
      }
      if (edge)
      {
        continue;
      }
      ++count[walls];
      const int gray = CutScene::Gray(behind.position);
      const Rgb opaque = behind.seen == CutScene::Seen::Nothing ? Window::kBackground
        : behind.seen == CutScene::Seen::Cut                    ? Rgb{ gray, gray, gray }
                                                                : Rgb{ 255, 0, 0 };
      const double left = std::pow(0.6, walls);
      const Rgb drawn = window.Color(i, j);
      for (std::size_t c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(drawn[c], left * opaque[c] + (c == 1 ? (1.0 - left) * 255.0 : 0.0), 2)
          << i << ", " << j << ", " << walls << " walls";
      }
    }
  }
  for (const int pixels : count)
  {
    EXPECT_GT(pixels, 500);
  }
}

/// The polygon offset determines which of two coincident planes is visible.
TEST(LayersInWindow, PolygonOffsetIsHonoured)
{
  CutScene scene;
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-1.0, -1.0, 0.0);
  source->SetPoint1(1.0, -1.0, 0.0);
  source->SetPoint2(-1.0, 1.0, 0.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> same;
  same->SetMapper(mapper);
  same->GetProperty()->SetColor(0.0, 0.0, 1.0);
  same->GetProperty()->LightingOff();
  Window window;
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(same);
  CutScene::Look(window.Renderer, false);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  const auto blue = [&]
  {
    window.Render();
    int others = 0;
    int pixels = 0;
    for (int j = 0; j < Window::kHeight; ++j)
    {
      for (int i = 0; i < Window::kWidth; ++i)
      {
        const Rgb color = window.Color(i, j);
        others += color != Window::kBackground ? 1 : 0;
        pixels += color == Rgb{ 0, 0, 255 } ? 1 : 0;
      }
    }
    EXPECT_GT(others, 5000);
    return static_cast<double>(pixels) / others;
  };
  scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 4.0);
  EXPECT_GT(blue(), 0.99);
  scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -4.0);
  EXPECT_LT(blue(), 0.01);
  scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 0.0);
  EXPECT_GT(blue(), 0.99);
  scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, 0.0);
  EXPECT_LT(blue(), 0.01);
  EXPECT_EQ(scene.Mapper->GetNumberOfTraces(), 1);
  scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, 0.0);
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}

/// Three layers with different fields, one of them translucent, lit, together with ordinary
/// geometry.
TEST(LayersInWindow, ThreeLayersWithTheirOwnFields)
{
  CutScene scene;
  vtkNew<vtkImplicitTorus> ring;
  ring->SetRadius(0.6);
  ring->SetTubeRadius(0.25);
  vtkNew<vtkLookupTable> rainbow;
  rainbow->SetRange(-1.0, 1.0);
  rainbow->SetVectorModeToComponent();
  rainbow->SetVectorComponent(1);
  vtkNew<vtkHighOrderLayer> torus;
  torus->SetCutFunction(ring);
  torus->SetFieldName("v");
  torus->SetLookupTable(rainbow);
  scene.Mapper->AddLayer(torus);
  vtkNew<vtkSphere> ball;
  ball->SetRadius(0.95);
  vtkNew<vtkHighOrderLayer> sphere;
  sphere->SetCutFunction(ball);
  sphere->SetOpacity(0.3);
  scene.Mapper->AddLayer(sphere);
  scene.Source->SetRadius(0.3);
  scene.Source->SetCenter(0.0, 0.0, 0.4);
  scene.Sphere->GetProperty()->LightingOn();
  Window window;
  window.Renderer->AddActor(scene.Cut);
  window.Renderer->AddActor(scene.Sphere);
  window.Renderer->SetUseDepthPeeling(true);
  window.RenderWindow->SetAlphaBitPlanes(1);
  CutScene::Look(window.Renderer, false);
  window.Render();
  vtkPointData* buffers = scene.Mapper->GetBuffers()->GetPointData();
  int count[3] = {};
  for (vtkIdType i = 0; i < scene.Mapper->GetBuffers()->GetNumberOfPoints(); ++i)
  {
    const double layer = buffers->GetArray("Layer")->GetComponent(i, 0);
    if (layer == 255.0)
    {
      continue;
    }
    ++count[static_cast<int>(layer)];
    double x[3];
    buffers->GetArray("Position")->GetTuple(i, x);
    const double value = buffers->GetArray("Value")->GetComponent(i, 0);
    const double expected =
      layer == 1.0 ? testing::FieldV(x[0], x[1], x[2])[1] : testing::FieldU(x[0], x[1], x[2]);
    ASSERT_NEAR(value, expected, 1e-12) << layer;
  }
  // The ball's wall is before nearly all.
  EXPECT_GT(count[0], 500);
  EXPECT_GT(count[2], 5000);
}
} // namespace pixelexact
