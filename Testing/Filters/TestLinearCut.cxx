// SPDX-License-Identifier: BSD-3-Clause
// vtkHighOrderLinearCut: against closed forms and VTK's own evaluation of cells, wrong use.
#include "Support.h"

#include "vtkHighOrderLinearCut.h"
#include "vtkHighOrderLinearResample.h"
#include "vtkHighOrderProbe.h"

#include "vtkCell.h"
#include "vtkCone.h"
#include "vtkCylinder.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using namespace pixelexact::testing;

struct Cutting
{
  vtkNew<vtkHighOrderLinearCut> filter;
  vtkNew<Messages> messages;

  Cutting(vtkDataObject* grid, vtkImplicitFunction* function)
  {
    messages->Watch(filter);
    filter->SetInputData(grid);
    filter->SetCutFunction(function);
  }
  vtkPolyData* At(int resolution)
  {
    filter->SetResolution(resolution);
    filter->Update();
    return filter->GetOutput();
  }
};

double AreaOf(vtkPolyData* surface)
{
  double area = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    double x[3][3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetCell(i)->GetPoints()->GetPoint(k, x[k]);
    }
    double u[3];
    double v[3];
    double normal[3];
    vtkMath::Subtract(x[1], x[0], u);
    vtkMath::Subtract(x[2], x[0], v);
    vtkMath::Cross(u, v, normal);
    area += 0.5 * vtkMath::Norm(normal);
  }
  return area;
}

/// The largest |S| over |grad S| of any point.
double FarthestOff(vtkPolyData* surface, vtkImplicitFunction* function)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double g[3];
    surface->GetPoint(i, x);
    function->FunctionGradient(x, g);
    largest = std::max(largest, std::fabs(function->FunctionValue(x)) / vtkMath::Norm(g));
  }
  return largest;
}

TEST(LinearCut, SlantedPlanesFillWhatTheyCut)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.5, 0.5, 0.5);
  plane->SetNormal(0.0, 1.0, 1.0); // a rectangle of 1 by sqrt 2
  Cutting cutting(Boxes(2), plane);
  vtkPolyData* output = cutting.At(16);
  ASSERT_EQ(cutting.messages->errors, "");
  EXPECT_NEAR(AreaOf(output), std::sqrt(2.0), 1e-9);
  EXPECT_EQ(output->GetNumberOfPolys(), 2 * 16 * 12);
  EXPECT_LT(FarthestOff(output, plane), 1e-14);
  EXPECT_EQ(cutting.filter->GetNumberOfTrianglesAtTheRim(), 0);
}

TEST(LinearCut, ValuesAtCornersAreThoseOfTheField)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.5, 0.5, 0.5);
  sphere->SetRadius(0.4);
  Cutting cutting(Boxes(2), sphere);
  vtkPolyData* output = cutting.At(24);
  vtkDataArray* f = output->GetPointData()->GetArray("f");
  ASSERT_NE(f, nullptr);
  ASSERT_GT(output->GetNumberOfPoints(), 1000);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    ASSERT_NEAR(f->GetTuple1(i), x[0] + 2.0 * x[1] + 3.0 * x[2], 1e-14);
  }
  EXPECT_LT(FarthestOff(output, sphere), 1e-15);
}

TEST(LinearCut, SurfacesOfEachKindAreOnTheirFunctionsAndClosed)
{
  const auto grid = Boxes(2);
  const auto middle = [](auto* function) { function->SetCenter(0.5, 0.5, 0.5); };
  vtkNew<vtkSphere> sphere;
  middle(sphere.Get());
  sphere->SetRadius(0.3);
  vtkNew<vtkCylinder> cylinder;
  middle(cylinder.Get());
  cylinder->SetRadius(0.25);
  cylinder->SetAxis(0.0, 0.0, 1.0);
  vtkNew<vtkCone> cone;
  cone->SetAngle(20.0);
  vtkNew<vtkTransform> shift;
  shift->Translate(0.1, -0.5, -0.5); // the apex is outside of the mesh
  cone->SetTransform(shift);
  vtkNew<vtkQuadric> saddle;
  saddle->SetCoefficients(1.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 1.0, 1.0, -0.5);
  vtkNew<vtkSuperquadric> superquadric; // no closed form of ours
  middle(superquadric.Get());
  superquadric->SetScale(0.3, 0.3, 0.3);
  superquadric->SetToroidal(0);
  const double pi = std::acos(-1.0);
  struct Case
  {
    vtkImplicitFunction* function;
    double area; ///< 0: not known
    double off;
  };
  for (const Case& surface :
    { Case{ sphere, 4.0 * pi * 0.09, 1e-14 }, Case{ cylinder, 2.0 * pi * 0.25, 1e-14 },
      Case{ cone, 0.0, 1e-14 }, Case{ saddle, 0.0, 1e-14 }, Case{ superquadric, 0.0, 0.0 } })
  {
    Cutting cutting(grid, surface.function);
    vtkPolyData* output = cutting.At(48);
    const std::string name = surface.function->GetClassName();
    ASSERT_EQ(cutting.messages->errors, "") << name;
    ASSERT_GT(output->GetNumberOfPolys(), 1000) << name;
    EXPECT_EQ(cutting.filter->GetNumberOfPointsOffSurface(), 0) << name;
    if (surface.off > 0.0)
    {
      EXPECT_LT(FarthestOff(output, surface.function), surface.off) << name;
    }
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(output);
    edges->FeatureEdgesOff();
    edges->BoundaryEdgesOff();
    edges->NonManifoldEdgesOn();
    edges->Update();
    EXPECT_EQ(edges->GetOutput()->GetNumberOfLines(), 0) << name;
    if (surface.function == sphere.Get())
    {
      edges->NonManifoldEdgesOff();
      edges->BoundaryEdgesOn();
      edges->Update();
      EXPECT_EQ(edges->GetOutput()->GetNumberOfLines(), 0);
    }
    if (surface.area > 0.0)
    {
      const double coarse = surface.area - AreaOf(cutting.At(24));
      const double fine = surface.area - AreaOf(cutting.At(48));
      EXPECT_NEAR(fine / surface.area, 0.0, 2e-3) << name;
      EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << name;
    }
  }
}

TEST(LinearCut, ThinAndSmallSurfacesAreFoundAtHighResolution)
{
  // Thinner than the largest cubes, between their corners.
  vtkNew<vtkCylinder> needle;
  needle->SetCenter(0.503, 0.0, 0.507);
  needle->SetRadius(0.004);
  vtkNew<vtkSphere> dot;
  dot->SetCenter(0.503, 0.505, 0.507);
  dot->SetRadius(0.004);
  const double pi = std::acos(-1.0);
  Cutting cylinder(Boxes(1), needle);
  EXPECT_NEAR(AreaOf(cylinder.At(1024)), 2.0 * pi * 0.004, 2e-2 * 2.0 * pi * 0.004);
  Cutting sphere(Boxes(1), dot);
  EXPECT_NEAR(AreaOf(sphere.At(1024)), 4.0 * pi * 1.6e-5, 2e-2 * 4.0 * pi * 1.6e-5);
}

TEST(LinearCut, EndsWhereTheMeshDoes)
{
  // The plane's part in a cube turned about z by 30 degrees is a square, whatever the grid.
  const auto grid = Boxes(2);
  vtkNew<vtkPoints> turned;
  turned->SetDataTypeToDouble();
  const double c = std::cos(0.5);
  const double s = std::sin(0.5);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    turned->InsertNextPoint(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]);
  }
  grid->SetPoints(turned);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.5);
  std::vector<double> missing;
  for (const int resolution : { 32, 64, 128, 256 })
  {
    Cutting cutting(grid, plane);
    missing.push_back(1.0 - AreaOf(cutting.At(resolution)));
    EXPECT_GT(cutting.filter->GetNumberOfTrianglesAtTheRim(), 2 * resolution);
  }
  // Corners of the square alone are cut off, which is second order in the spacing.
  EXPECT_GE(missing.back(), 0.0);
  EXPECT_LT(missing.front(), 4.0 / (32 * 32));
  EXPECT_LT(missing.back(), missing.front() / 16.0);
}

TEST(LinearCut, LinearInterpolationConvergesAtSecondOrder)
{
  // The mean error decreases. The field has kinks between elements, across which single triangles
  // have larger errors.
  const auto grid = ReadGrid(kToroid);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.1);
  std::vector<double> errors;
  for (const int resolution : { 64, 128, 256 })
  {
    Cutting cutting(grid, plane);
    vtkPolyData* output = cutting.At(resolution);
    vtkNew<vtkPolyData> middles;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    std::vector<double> linear;
    vtkDataArray* u = output->GetPointData()->GetArray("u");
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      double sum[3] = { 0.0, 0.0, 0.0 };
      double value = 0.0;
      vtkCell* cell = output->GetCell(i);
      for (int k = 0; k < 3; ++k)
      {
        double x[3];
        cell->GetPoints()->GetPoint(k, x);
        vtkMath::Add(sum, x, sum);
        value += u->GetTuple1(cell->GetPointId(k)) / 3.0;
      }
      vtkMath::MultiplyScalar(sum, 1.0 / 3.0);
      points->InsertNextPoint(sum);
      linear.push_back(value);
    }
    middles->SetPoints(points);
    vtkNew<vtkHighOrderProbe> probe;
    probe->SetInputData(0, middles);
    probe->SetInputData(1, grid);
    probe->Update();
    vtkDataArray* exact = probe->GetPolyDataOutput()->GetPointData()->GetArray("u");
    double sum = 0.0;
    int inside = 0;
    for (std::size_t i = 0; i < linear.size(); ++i)
    {
      const double miss = std::fabs(exact->GetTuple1(static_cast<vtkIdType>(i)) - linear[i]);
      sum += std::isnan(miss) ? 0.0 : miss;
      inside += std::isnan(miss) ? 0 : 1;
    }
    ASSERT_GT(inside, 0.99 * static_cast<double>(linear.size()));
    errors.push_back(sum / inside);
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.4);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.3);
}

TEST(LinearCut, IsTheSameForAnyNumberOfThreads)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(1.0);
  const auto grid = ReadGrid(kToroid);
  Cutting many(grid, sphere);
  vtkPolyData* output = many.At(64);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  Cutting alone(grid, sphere);
  vtkPolyData* serial = alone.At(64);
  ASSERT_GT(output->GetNumberOfPoints(), 100);
  ASSERT_EQ(output->GetNumberOfPoints(), serial->GetNumberOfPoints());
  vtkDataArray* a = output->GetPointData()->GetArray("u");
  vtkDataArray* b = serial->GetPointData()->GetArray("u");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    output->GetPoint(i, p);
    serial->GetPoint(i, q);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) << i;
    ASSERT_EQ(a->GetTuple1(i), b->GetTuple1(i)) << i;
  }
}

/// Aborts when a part of the work is done.
class AbortAt : public vtkCommand
{
public:
  static AbortAt* New() { return new AbortAt; }
  void Execute(vtkObject* caller, unsigned long /*event*/, void* data) override
  {
    if (*static_cast<double*>(data) >= part)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  }
  double part = 0.5;
};

TEST(LinearCut, Aborts)
{
  vtkNew<vtkSphere> sphere;
  vtkNew<AbortAt> abort;
  for (const double part : { 0.05, 0.5 })
  {
    abort->part = part;
    Cutting cutting(ReadGrid(kToroid), sphere);
    cutting.filter->AddObserver(vtkCommand::ProgressEvent, abort);
    EXPECT_EQ(cutting.At(64)->GetNumberOfPoints(), 0) << part;
    EXPECT_EQ(cutting.messages->errors, "");
  }
  vtkNew<vtkHighOrderLinearResample> resample;
  resample->SetInputData(ReadGrid(kToroid));
  abort->part = 0.2;
  resample->AddObserver(vtkCommand::ProgressEvent, abort);
  resample->Update();
  EXPECT_EQ(resample->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LinearCut, WrongUseIsNamed)
{
  const auto refused = [](Cutting& cutting, int resolution, const std::string& text)
  {
    EXPECT_EQ(cutting.At(resolution)->GetNumberOfPoints(), 0);
    EXPECT_NE(cutting.messages->errors.find(text), std::string::npos) << cutting.messages->errors;
  };
  const auto grid = Boxes(1);
  Cutting nothing(grid, nullptr);
  refused(nothing, 4, "SetCutFunction");

  vtkNew<vtkPlane> plane;
  Cutting field(grid, plane);
  field.filter->AddField("no such");
  refused(field, 4, "no field 'no such'; choose one of 'f'");

  Cutting large(grid, plane);
  plane->SetOrigin(0.5, 0.5, 0.5);
  refused(large, 1000000, "1000000000000 squares on the plane need");

  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.5, 0.5, 0.5);
  sphere->SetRadius(0.4);
  Cutting samples(grid, sphere);
  refused(samples, 100000, "cubes about the surface need");
  EXPECT_NE(samples.messages->errors.find("lower the resolution"), std::string::npos);

  vtkNew<Messages> messages;
  vtkNew<vtkHighOrderLinearResample> resample;
  messages->Watch(resample);
  resample->SetInputData(grid);
  resample->SetDimensions(20000, 20000, 20000);
  resample->Update();
  EXPECT_NE(messages->errors.find("8000000000000 nodes need"), std::string::npos)
    << messages->errors;
}

TEST(LinearCut, SurfacesThatMissTheMeshAreEmpty)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 9.0);
  Cutting flat(Boxes(1), plane);
  EXPECT_EQ(flat.At(8)->GetNumberOfPoints(), 0);
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(9.0, 9.0, 9.0);
  Cutting round(Boxes(1), sphere);
  EXPECT_EQ(round.At(8)->GetNumberOfPoints(), 0);
  EXPECT_EQ(flat.messages->errors + round.messages->errors, "");
}
} // namespace
