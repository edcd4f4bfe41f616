// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Trace/RayCheck.h"
#include "VtkSurface.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPerspectiveTransform.h"
#include "vtkPlane.h"
#include "vtkSphere.h"
#include "vtkThinPlateSplineTransform.h"
#include "vtkTransform.h"

#include <limits>

namespace pixelexact::testing
{
namespace
{
constexpr double kOrigin[3] = { 0.1, -0.2, 0.3 };
constexpr double kNormal[3] = { 2.0, 1.0, -3.0 };

vtkNew<vtkPlane> MakePlane()
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(kOrigin);
  plane->SetNormal(kNormal);
  return plane;
}

/// A row of numbers times (x, 1).
long double Apply(const std::array<long double, 4>& row, const LongVec3& x)
{
  return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
}

/// MakePlane's function of A x is row . (x, 1) over last . (x, 1).
struct MovedPlane
{
  std::array<long double, 4> row{};
  std::array<long double, 4> last{ 0.0L, 0.0L, 0.0L, 1.0L };

  explicit MovedPlane(vtkHomogeneousTransform* transform)
  {
    vtkNew<vtkMatrix4x4> matrix;
    if (transform != nullptr)
    {
      transform->Update();
      matrix->DeepCopy(transform->GetMatrix());
    }
    std::array<long double, 4> plane{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      plane[i] = kNormal[i];
      plane[3] -= static_cast<long double>(kNormal[i]) * kOrigin[i];
    }
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        row[j] += plane[i] * matrix->GetElement(i, j);
      }
      last[j] = matrix->GetElement(3, j);
    }
  }

  [[nodiscard]] LongVec3 Normal() const { return { row[0], row[1], row[2] }; }
  [[nodiscard]] long double Slope() const { return std::sqrt(Dot(Normal(), Normal())); }

  [[nodiscard]] LongPlane Zeros() const
  {
    LongPlane plane(Times(-row[3] / Dot(Normal(), Normal()), Normal()), Normal());
    // The matrix and its inverse, of condition 4, are products of some numbers; the origin that
    // they move is about 1 from the world's.
    plane.roundings = 64.0L;
    plane.offset = plane.roundings * kUnitRoundoff;
    return plane;
  }
};

/// The hits of rays with the surface are the zeros of the function, and all of them.
void ExpectZeros(vtkHomogeneousTransform* transform)
{
  const auto function = MakePlane();
  function->SetTransform(transform);
  const auto surface = ToSurface(function);
  const MovedPlane moved(transform);
  const LongPlane truth = moved.Zeros();
  RandomRays random(1);
  std::vector<Ray> rays;
  std::vector<TrueHit> hits;
  std::vector<double> tMin;
  for (int i = 0; i < 2000; ++i)
  {
    rays.push_back(random.Near(ToDouble(truth.origin), ToDouble(truth.normal)));
    hits.push_back(truth.Meet(rays.back()));
    tMin.push_back(random.Start(hits.back().t));
  }
  const auto found = AllHits(*surface, rays, tMin);
  int certain = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    certain += ExpectHits(found[i], { hits[i] }, tMin[i]);
    for (const auto& [t, position] : found[i])
    {
      const LongVec3 x = ToLong(position);
      const long double error = truth.DistanceError(x);
      EXPECT_LE(truth.Distance(x), error);
      // VTK has the last word on what its function is; its own rounding is of the same size.
      const long double value = function->FunctionValue(position.x, position.y, position.z);
      EXPECT_LE(std::fabs(value * Apply(moved.last, x)), 2.0L * error * moved.Slope());
    }
  }
  EXPECT_GT(certain, 500);
}
} // namespace

TEST(VtkSurface, PlaneWithAndWithoutTransform)
{
  ExpectZeros(nullptr);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.3, 0.2, -0.1);
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  transform->Scale(2.0, 0.5, -1.0);
  ExpectZeros(transform);
  vtkNew<vtkPerspectiveTransform> perspective;
  const double matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.05, 0, 1 };
  perspective->SetMatrix(matrix);
  ExpectZeros(perspective);
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
} // namespace pixelexact::testing
