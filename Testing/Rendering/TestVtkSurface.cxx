// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Error.h"
#include "Surfaces/VtkSurface.h"
#include "Trace/RayCheck.h"

#include "vtkBox.h"
#include "vtkCone.h"
#include "vtkCylinder.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitTorus.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPerspectiveTransform.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"
#include "vtkSuperquadric.h"
#include "vtkThinPlateSplineTransform.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>

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

/// A plane with the name and behaviour of ParaView's widgets' plane: an offset along the normal.
class vtkPVPlane : public vtkPlane
{
public:
  static vtkPVPlane* New() { VTK_STANDARD_NEW_BODY(vtkPVPlane); }
  vtkTypeMacro(vtkPVPlane, vtkPlane);
  using vtkPlane::EvaluateFunction;
  double EvaluateFunction(double x[3]) override
  {
    return this->vtkPlane::EvaluateFunction(x) - 0.25 * vtkMath::Norm(this->Normal);
  }
};

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
  std::vector<double> tNear;
  for (int i = 0; i < 2000; ++i)
  {
    rays.push_back(random.Near(ToDouble(truth.origin), ToDouble(truth.normal)));
    hits.push_back(truth.Meet(rays.back()));
    tNear.push_back(std::max(kNearest, random.Start(hits.back().t)));
  }
  const auto found = AllHits(*surface, rays, tNear);
  int certain = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    certain += ExpectHits(found[i], { hits[i] }, tNear[i]);
    for (const auto& [t, position, status] : found[i])
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

TEST(VtkSurface, ParaViewsPlaneIsAPlane)
{
  vtkNew<vtkPVPlane> plane;
  plane->SetOrigin(kOrigin);
  plane->SetNormal(kNormal);
  const auto surface = ToSurface(plane);
  EXPECT_TRUE(surface->IsFlat());
  // The plane is where n . (x - o) = |n| / 4.
  Ray ray;
  ray.origin = { kOrigin[0], kOrigin[1], kOrigin[2] };
  ray.direction = glm::normalize(Vec3(kNormal[0], kNormal[1], kNormal[2]));
  EXPECT_NEAR(HitsOf(*surface, ray).at(0).t, 0.25, 1e-15);
}

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
  EXPECT_EQ(HitsOf(*ToSurface(plane), ray).at(0).t, 11.0);
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

namespace
{
/// Checks that rays about a place meet the surface where VTK's function is zero, and at every
/// change of its sign.
void ExpectZerosOf(vtkImplicitFunction* function, const Vec3& place, double size)
{
  const auto surface = ToSurface(function);
  RandomRays random(7);
  int found = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 from = place + random.Vector(2.0 * size);
    const Vec3 along = ToDouble(Unit(ToLong(place + random.Vector(size) - from)));
    const auto valueAt = [&](double t)
    {
      const Vec3 x = from + t * along;
      return function->FunctionValue(x.x, x.y, x.z);
    };
    const std::vector<Hit> hits = HitsOf(*surface, { from, along });
    std::vector<double> ends{ 1e-9 };
    for (const Hit& hit : hits)
    {
      ++found;
      EXPECT_EQ(hit.status, HitStatus::Certain);
      // On both sides of a hit the function has different signs.
      const double aside = 1e-7 * size;
      EXPECT_LE(valueAt(hit.t - aside) * valueAt(hit.t + aside), 0.0)
        << function->GetClassName() << " at " << hit.t;
      const Vec3 normal = surface->Normal({ hit.position });
      double gradient[3];
      const double x[3] = { hit.position.x, hit.position.y, hit.position.z };
      function->FunctionGradient(x, gradient);
      const LongVec3 across{ gradient[0], gradient[1], gradient[2] };
      EXPECT_LE(Largest(Cross(Unit(across), ToLong(normal))), 1e-12L) << function->GetClassName();
      ends.push_back(hit.t);
    }
    ends.push_back(6.0 * size);
    // Between hits it has one sign.
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
      const double first = valueAt(ends[k - 1] + 0.01 * (ends[k] - ends[k - 1]));
      for (int part = 2; part < 100; ++part)
      {
        const double value = valueAt(ends[k - 1] + 0.01 * part * (ends[k] - ends[k - 1]));
        EXPECT_GT(value * first, 0.0) << function->GetClassName();
      }
    }
  }
  EXPECT_GT(found, 50) << function->GetClassName();
}

/// Checks a function without a transform, and with one.
template <class Function>
void ExpectZerosMovedOrNot(Function* function)
{
  ExpectZerosOf(function, { 0.2, -0.1, 0.3 }, 1.0);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.3, 0.2, -0.1);
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  transform->Scale(1.5, 0.75, 1.25);
  function->SetTransform(transform);
  ExpectZerosOf(function, { 0.1, 0.0, 0.2 }, 1.0);
}

/// Whether the ray's hits have this status, and the function the other sign beyond each.
void ExpectSignsChange(vtkImplicitFunction* function, const Surface& surface, HitStatus status)
{
  RandomRays random(8);
  int count = 0;
  for (int k = 0; k < 400; ++k)
  {
    const Vec3 origin = random.Vector(3.0);
    const Ray ray{ origin, glm::normalize(random.Vector(0.8) - origin) };
    for (const Hit& hit : HitsOf(surface, ray))
    {
      const auto value = [&](double t)
      {
        const Vec3 x = ray.origin + t * ray.direction;
        return function->FunctionValue(x.x, x.y, x.z);
      };
      EXPECT_LT(value(hit.t - 1e-7) * value(hit.t + 1e-7), 0.0);
      EXPECT_EQ(hit.status, status);
      ++count;
    }
  }
  EXPECT_GT(count, 300);
}
constexpr SurfaceSearch kSearch{ { Vec3(-2.0), Vec3(2.0) }, 200 };
} // namespace

TEST(VtkSurface, BooleansAreMadeOfTheirPartsHits)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.9);
  vtkNew<vtkBox> box;
  box->SetBounds(-0.5, 1.5, -0.4, 1.0, -0.6, 0.7);
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetRadius(0.3);
  vtkNew<vtkTransform> turned;
  turned->RotateX(70.0);
  cylinder->SetTransform(turned);
  for (const int operation : { vtkImplicitBoolean::VTK_UNION, vtkImplicitBoolean::VTK_INTERSECTION,
         vtkImplicitBoolean::VTK_DIFFERENCE })
  {
    vtkNew<vtkImplicitBoolean> inner;
    inner->SetOperationType(operation);
    inner->AddFunction(sphere);
    inner->AddFunction(box);
    vtkNew<vtkImplicitBoolean> outer;
    outer->SetOperationTypeToDifference();
    outer->AddFunction(inner);
    outer->AddFunction(cylinder);
    ExpectSignsChange(outer, *ToSurface(outer), HitStatus::Certain);
    // Moved as a whole it is searched for.
    outer->SetTransform(turned);
    EXPECT_THROW((void)ToSurface(outer), Unsupported);
    ExpectSignsChange(outer, *ToSurface(outer, kSearch), HitStatus::Numeric);
  }
  vtkNew<vtkImplicitBoolean> magnitudes;
  magnitudes->SetOperationTypeToUnionOfMagnitudes();
  magnitudes->AddFunction(sphere);
  EXPECT_THROW((void)ToSurface(magnitudes, kSearch), Error);
  vtkNew<vtkImplicitBoolean> empty;
  EXPECT_THROW((void)ToSurface(empty, kSearch), Error);
}

TEST(VtkSurface, AnyOtherFunctionIsSearchedFor)
{
  vtkNew<vtkSuperquadric> superquadric;
  superquadric->SetSize(1.0);
  superquadric->SetPhiRoundness(0.7);
  ExpectSignsChange(superquadric, *ToSurface(superquadric, kSearch), HitStatus::Numeric);
  vtkNew<vtkPerspectiveTransform> perspective;
  const double matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.05, 0, 1 };
  perspective->SetMatrix(matrix);
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(0.8);
  sphere->SetTransform(perspective);
  ExpectSignsChange(sphere, *ToSurface(sphere, kSearch), HitStatus::Numeric);
}

TEST(VtkSurface, CurvedFunctionsAndBodies)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(0.3, -0.2, 0.1);
  sphere->SetRadius(0.7);
  ExpectZerosMovedOrNot<vtkSphere>(sphere);
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetCenter(0.1, 0.2, 0.3);
  cylinder->SetAxis(1.0, 2.0, -1.0);
  cylinder->SetRadius(0.4);
  ExpectZerosMovedOrNot<vtkCylinder>(cylinder);
  vtkNew<vtkCone> cone;
  cone->SetAngle(35.0);
  ExpectZerosMovedOrNot<vtkCone>(cone);
  vtkNew<vtkQuadric> quadric;
  quadric->SetCoefficients(1.0, -0.5, 0.25, 0.1, -0.2, 0.3, 0.05, -0.1, 0.2, -0.3);
  ExpectZerosMovedOrNot<vtkQuadric>(quadric);
  vtkNew<vtkBox> box;
  box->SetBounds(-0.4, 0.6, -0.3, 0.5, -0.2, 0.9);
  ExpectZerosMovedOrNot<vtkBox>(box);
  vtkNew<vtkPlanes> planes;
  const double bounds[6] = { -0.4, 0.6, -0.3, 0.5, -0.2, 0.9 };
  planes->SetBounds(bounds);
  ExpectZerosMovedOrNot<vtkPlanes>(planes);
  vtkNew<vtkImplicitTorus> torus;
  torus->SetCenter(0.1, -0.1, 0.2);
  torus->SetAxis(1.0, 1.0, 3.0);
  torus->SetRadius(0.7);
  torus->SetTubeRadius(0.2);
  ExpectZerosOf(torus, { 0.1, -0.1, 0.2 }, 1.0);
}

TEST(VtkSurface, WhatIsNotSupportedIsNamed)
{
  vtkNew<vtkSuperquadric> superquadric;
  try
  {
    (void)ToSurface(superquadric);
    FAIL();
  }
  catch (const Unsupported& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("vtkSuperquadric"), std::string::npos) << text;
    EXPECT_NE(text.find("vtkPlane"), std::string::npos) << text;
  }
  const auto plane = MakePlane();
  vtkNew<vtkThinPlateSplineTransform> spline;
  plane->SetTransform(spline);
  EXPECT_THROW((void)ToSurface(plane), Unsupported);
  vtkNew<vtkPerspectiveTransform> perspective;
  const double matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.05, 0, 1 };
  perspective->SetMatrix(matrix);
  vtkNew<vtkSphere> sphere;
  sphere->SetTransform(perspective);
  EXPECT_THROW((void)ToSurface(sphere), Unsupported);
  sphere->SetTransform(static_cast<vtkAbstractTransform*>(nullptr));
  sphere->SetRadius(-1.0);
  EXPECT_THROW((void)ToSurface(sphere), Error);
  vtkNew<vtkPlanes> none;
  EXPECT_THROW((void)ToSurface(none), Error);
  vtkNew<vtkImplicitTorus> torus;
  torus->SetTransform(perspective);
  EXPECT_THROW((void)ToSurface(torus), Unsupported);
}
} // namespace pixelexact::testing
