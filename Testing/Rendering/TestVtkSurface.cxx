// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Trace/Surface.h"
#include "VtkSurface.h"

#include "vtkNew.h"
#include "vtkPerspectiveTransform.h"
#include "vtkPlane.h"
#include "vtkSphere.h"
#include "vtkThinPlateSplineTransform.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace pixelexact
{
namespace
{
/// The hits of rays with the surface are zeros of the function.
void ExpectZeros(vtkImplicitFunction* function, double tolerance)
{
  const auto surface = ToSurface(function);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int hits = 0;
  for (int i = 0; i < 100; ++i)
  {
    const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
    const Ray ray{ vector(), glm::normalize(vector()) };
    const auto [t, x] = NextHitOf(*surface, ray, 0.0);
    if (t < 1e3)
    {
      ++hits;
      EXPECT_NEAR(function->FunctionValue(x.x, x.y, x.z), 0.0, tolerance);
    }
  }
  EXPECT_GT(hits, 20);
}

vtkNew<vtkPlane> MakePlane()
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, -0.2, 0.3);
  plane->SetNormal(2.0, 1.0, -3.0);
  return plane;
}
} // namespace

TEST(VtkSurface, PlaneWithAndWithoutTransform)
{
  const auto plane = MakePlane();
  ExpectZeros(plane, 1e-12);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.3, 0.2, -0.1);
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  transform->Scale(2.0, 0.5, -1.0);
  plane->SetTransform(transform);
  ExpectZeros(plane, 1e-12);
  vtkNew<vtkPerspectiveTransform> perspective;
  const double matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.05, 0, 1 };
  perspective->SetMatrix(matrix);
  plane->SetTransform(perspective);
  ExpectZeros(plane, 1e-10);
}

TEST(VtkSurface, FarFromTheOriginKeepsItsDigits)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1e8, 1e8, 1e8);
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.0, 0.0, 1.0);
  plane->SetTransform(transform);
  const Ray ray{ { 1e8, 1e8, 1e8 + 10.0 }, { 0.0, 0.0, -1.0 } };
  EXPECT_EQ(NextHitOf(*ToSurface(plane), ray, 0.0).t, 11.0);
}

TEST(VtkSurface, NonsenseIsRefused)
{
  const auto plane = MakePlane();
  plane->SetNormal(0.0, 0.0, 0.0);
  EXPECT_THROW((void)ToSurface(plane), Error);
  plane->SetNormal(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_THROW((void)ToSurface(plane), Error);
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 1.0, 1e-200);
  flat->Scale(1.0, 1.0, 1e-200);
  plane->SetTransform(flat);
  EXPECT_THROW((void)ToSurface(plane), Error);
  EXPECT_THROW((void)ToSurface(nullptr), Error);
}

TEST(VtkSurface, WhatIsNotSupportedIsNamed)
{
  vtkNew<vtkSphere> sphere;
  try
  {
    (void)ToSurface(sphere);
    FAIL();
  }
  catch (const Unsupported& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("vtkSphere"), std::string::npos) << text;
    EXPECT_NE(text.find("vtkPlane"), std::string::npos) << text;
  }
  const auto plane = MakePlane();
  vtkNew<vtkThinPlateSplineTransform> spline;
  plane->SetTransform(spline);
  EXPECT_THROW((void)ToSurface(plane), Unsupported);
}
} // namespace pixelexact
