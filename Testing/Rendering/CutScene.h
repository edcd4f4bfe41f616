// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BoxGrid.h"
#include "Window.h"

#include "HighOrderModel.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"
#include "Views/VtkCamera.h"
#include "vtkHighOrderMapper.h"

#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cstring>
#include <functional>
#include <optional>
#include <vector>

namespace pixelexact::testing
{
/// The same bytes, so that NaNs are equal and signs of zeros are not.
template <typename T>
bool SameBytes(const std::vector<T>& ours, vtkDataArray* theirs)
{
  return theirs != nullptr &&
    static_cast<std::size_t>(theirs->GetDataSize()) * theirs->GetDataTypeSize() ==
    ours.size() * sizeof(T) &&
    std::memcmp(ours.data(), theirs->GetVoidPointer(0), ours.size() * sizeof(T)) == 0;
}

/// The plane z = 0 through BoxGrid(2), gray by "u", and a red sphere that the plane cuts in two,
/// in VTK's objects and in closed form.
class CutScene
{
public:
  static constexpr double kRadius = 0.5;
  static inline const Vec3 kCentre{ 0.2, -0.1, -0.1 };
  static constexpr double kRange[2] = { -1.0, 2.0 };

  CutScene()
  {
    Table->SetNumberOfTableValues(256);
    Table->SetHueRange(0.0, 0.0);
    Table->SetSaturationRange(0.0, 0.0);
    Table->SetValueRange(0.0, 1.0);
    Table->SetRampToLinear();
    Function->SetNormal(0.0, 0.0, 1.0);
    Mapper->SetInputData(Grid);
    Mapper->SetFieldName("u");
    Mapper->SetCutFunction(Function);
    Mapper->SetLookupTable(Table);
    Mapper->SetScalarRange(kRange[0], kRange[1]);
    Cut->SetMapper(Mapper);

    Source->SetRadius(kRadius);
    Source->SetCenter(kCentre.x, kCentre.y, kCentre.z);
    Source->SetPhiResolution(400);
    Source->SetThetaResolution(400);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(Source->GetOutputPort());
    Sphere->SetMapper(mapper);
    Sphere->GetProperty()->SetColor(1.0, 0.0, 0.0);
    Sphere->GetProperty()->LightingOff();
  }

  /// Looks down at the plane from the side.
  static void Look(vtkRenderer* renderer, bool parallel)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(1.0, -3.6, 2.0);
    camera->SetFocalPoint(0.1, 0.0, -0.1);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(1.2);
    renderer->ResetCameraClippingRange();
  }

  /// The first object that a ray meets.
  enum class Seen
  {
    Nothing,
    Cut,
    Sphere
  };
  struct Expected
  {
    Seen seen = Seen::Nothing;
    Vec3 position{ 0.0 };
  };
  static Expected Meet(const Ray& ray)
  {
    Expected expected;
    double nearest = kNoHit;
    const double tPlane = -ray.origin.z / ray.direction.z;
    const Vec3 x = ray.origin + tPlane * ray.direction;
    if (tPlane > 0.0 && std::max(std::abs(x.x), std::abs(x.y)) <= 1.0)
    {
      nearest = tPlane;
      expected = { Seen::Cut, x };
    }
    const Vec3 o = ray.origin - kCentre;
    const double b = glm::dot(o, ray.direction);
    const double discriminant = b * b - glm::dot(o, o) + kRadius * kRadius;
    const double tSphere = -b - std::sqrt(std::max(discriminant, 0.0));
    if (discriminant > 0.0 && tSphere > 0.0 && tSphere < nearest)
    {
      expected = { Seen::Sphere, ray.origin + tSphere * ray.direction };
    }
    return expected;
  }

  static int Gray(const Vec3& x)
  {
    const double part = (FieldU(x.x, x.y, x.z) - kRange[0]) / (kRange[1] - kRange[0]);
    return static_cast<int>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
  }

  /// Checks colours and depths of all pixels of a viewport whose neighbours see the same thing;
  /// `over` is what lies before everything (a translucent layer).
  static void ExpectPicture(Window& window, const std::array<int, 4>& viewport,
    const std::function<Rgb(const Rgb&)>& over = {}, bool checkDepth = true)
  {
    vtkCamera* camera = window.Renderer->GetActiveCamera();
    const auto [left, bottom, width, height] = viewport;
    const VtkRays rays(camera, width, height);
    const auto meet = [&](double x, double y) { return Meet(rays.At(x, y)); };
    int count[3] = { 0, 0, 0 };
    for (int j = 1; j < height - 1; ++j)
    {
      for (int i = 1; i < width - 1; ++i)
      {
        const Expected expected = meet(i + 0.5, j + 0.5);
        bool edge = false;
        for (const double dx : { -1.0, 0.0, 1.0 })
        {
          for (const double dy : { -1.0, 0.0, 1.0 })
          {
            edge = edge || meet(i + 0.5 + dx, j + 0.5 + dy).seen != expected.seen;
          }
        }
        if (edge)
        {
          continue;
        }
        ++count[static_cast<int>(expected.seen)];
        Rgb color = Window::kBackground;
        double depth = 1.0;
        double tolerance = 0.0;
        if (expected.seen != Seen::Nothing)
        {
          const int gray = Gray(expected.position);
          color = expected.seen == Seen::Cut ? Rgb{ gray, gray, gray } : Rgb{ 255, 0, 0 };
          depth = VtkDepth(camera, expected.position, width, height);
          // VTK's sphere consists of triangles and is steep at its outline.
          tolerance = expected.seen == Seen::Cut ? 3e-7 : 4e-3;
        }
        color = over ? over(color) : color;
        const Rgb drawn = window.Color(left + i, bottom + j);
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(drawn[c], color[c], over ? 3 : 1) << i << ", " << j << ", channel " << c;
        }
        if (checkDepth)
        {
          ASSERT_NEAR(window.Depth(left + i, bottom + j), depth, tolerance) << i << ", " << j;
        }
      }
    }
    // The scene is what it is meant to be.
    for (const int pixels : count)
    {
      ASSERT_GT(pixels, width * height / 20);
    }
  }

  /// The frame of the same view straight from the tracer.
  Frame Traced(vtkRenderer* renderer, int width, int height, Buffer buffers,
    const char* field = "u", int component = 0)
  {
    Model = HighOrderModel::From(Grid);
    Scene scene;
    scene.locator = &Model->GetLocator();
    scene.layers.push_back({ std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0)),
      Model->FindField(field), component });
    const Camera camera(ViewOf(renderer->GetActiveCamera()), width, height);
    return Trace(scene, camera, {}, { .centres = buffers });
  }

  vtkSmartPointer<vtkUnstructuredGrid> Grid = BoxGrid(2);
  vtkNew<vtkPlane> Function;
  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkHighOrderMapper> Mapper;
  vtkNew<vtkActor> Cut;
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkActor> Sphere;

private:
  std::shared_ptr<HighOrderModel> Model;
};
} // namespace pixelexact::testing
