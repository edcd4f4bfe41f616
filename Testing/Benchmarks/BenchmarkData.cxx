// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkData.h"

#include "Trace/Surfaces/Plane.h"
#include "Trace/Tracer.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkLagrangeHexahedron.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGridToHighOrderGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace pixelexact::benchmarks
{
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> ReadToroid()
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(PIXELEXACT_DATA_DIR "/toroid_hex_g3_p6.vtu");
  reader->Update();
  return reader->GetOutput();
}

/// A block of n^3 Lagrange hexahedra of order 3, bent by a smooth map, with a smooth field.
vtkSmartPointer<vtkUnstructuredGrid> MakeBlock(int n)
{
  constexpr int kOrder = 3;
  const int side = kOrder * n + 1;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("u");
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        const double a = 2.0 * i / (side - 1) - 1.0;
        const double b = 2.0 * j / (side - 1) - 1.0;
        const double c = 2.0 * k / (side - 1) - 1.0;
        points->InsertNextPoint(a + 0.05 * std::sin(3.0 * b + c), b + 0.05 * std::sin(3.0 * c + a),
          c + 0.05 * std::sin(3.0 * a + b));
        values->InsertNextValue(std::sin(9.0 * a) * std::cos(7.0 * b + 5.0 * c));
      }
    }
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(values);
  grid->Allocate(n * n * n);
  const int order[3] = { kOrder, kOrder, kOrder };
  std::vector<vtkIdType> nodes(64);
  for (int e = 0; e < n * n * n; ++e)
  {
    const int corner[3] = { e % n * kOrder, e / n % n * kOrder, e / (n * n) * kOrder };
    for (int k = 0; k <= kOrder; ++k)
    {
      for (int j = 0; j <= kOrder; ++j)
      {
        for (int i = 0; i <= kOrder; ++i)
        {
          nodes[static_cast<std::size_t>(
            vtkLagrangeHexahedron::PointIndexFromIJK(i, j, k, order))] =
            corner[0] + i + side * (corner[1] + j + static_cast<vtkIdType>(side) * (corner[2] + k));
        }
      }
    }
    grid->InsertNextCell(VTK_LAGRANGE_HEXAHEDRON, 64, nodes.data());
  }
  return grid;
}

PlaneCut MakePlaneCut(const char* name, vtkUnstructuredGrid* source, const Vec3& normal)
{
  PlaneCut cut;
  cut.name = name;
  cut.source = source;
  vtkNew<vtkUnstructuredGridToHighOrderGrid> convert;
  convert->SetInputData(source);
  convert->Update();
  cut.model = HighOrderModel::From(convert->GetOutput());
  cut.field = cut.model->FindField("u");
  const Box3& bounds = cut.model->GetLocator().Bounds();
  cut.origin = 0.5 * (bounds.lower + bounds.upper);
  cut.normal = glm::normalize(normal);

  Scene scene;
  scene.locator = &cut.model->GetLocator();
  scene.layers.push_back({ std::make_shared<Plane>(cut.origin, cut.normal), cut.field });
  cut.frame = Trace(scene, ViewOf(cut, 1000), {},
    { .centres = Buffer::Value | Buffer::Position | Buffer::Xi | Buffer::Verdict });
  for (std::size_t i = 0; i < cut.frame.centres.Size(); ++i)
  {
    if (cut.frame.centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
    {
      cut.inside.push_back(cut.frame.centres.position[i]);
      cut.values.push_back(cut.frame.centres.value[i]);
    }
  }
  return cut;
}
} // namespace

Camera ViewOf(const PlaneCut& cut, int pixels)
{
  const Box3& bounds = cut.model->GetLocator().Bounds();
  CameraView view;
  view.focalPoint = cut.origin;
  const double radius = glm::length(bounds.upper - cut.origin);
  view.position = cut.origin + 3.0 * radius * cut.normal;
  view.viewUp = std::fabs(cut.normal.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
  view.parallel = true;
  view.parallelScale = 0.6 * radius;
  return { view, pixels, pixels };
}

const PlaneCut& GetPlaneCut(int set)
{
  static const PlaneCut cuts[] = {
    MakePlaneCut("toroid_hex_g3_p6, 48 elements", ReadToroid(), { 0.0, 0.0, 1.0 }),
    MakePlaneCut("block_hex_g3_p3, 21952 elements", MakeBlock(28), { 0.2, 0.3, 1.0 }),
  };
  return cuts[set];
}

vtkSmartPointer<vtkPolyData> PointsOf(const PlaneCut& cut, std::size_t stride)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < cut.inside.size(); i += stride)
  {
    points->InsertNextPoint(cut.inside[i].x, cut.inside[i].y, cut.inside[i].z);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}
} // namespace pixelexact::benchmarks
