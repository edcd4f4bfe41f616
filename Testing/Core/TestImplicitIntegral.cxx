// SPDX-License-Identifier: BSD-3-Clause
// Integrals over iso-surfaces, tori, and surfaces that are clipped: against closed forms, on
// straight and curved meshes; wrong use.
#include "CurvedMeshes.h"
#include "IntegralCheck.h"

#include "Core/Base/Error.h"
#include "Core/Integral/ClippedSquare.h"
#include "Core/Integral/IntegralCut.h"
#include "Core/Integral/Integrate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pixelexact::testing
{
namespace
{
SurfaceIntegral Over(const IntegralCut& cut, const Mesh& mesh, const Field* field, double tolerance,
  std::span<const ImplicitPolynomial> clips = {})
{
  const Locator locator(mesh);
  const FaceTable faces(locator.Index());
  IntegralEffort effort;
  effort.tolerance = tolerance;
  return IntegrateCut({ mesh, field, &cut, clips }, locator, faces, effort);
}

/// A function of the place as a field on a curved mesh, which its space has to hold.
template <class F>
ExpansionBuilder OnMesh(const Mesh& mesh, int order, int components, const F& f)
{
  ExpansionBuilder values(components);
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    values.Add(UniformSpace(mesh.ShapeOf(e), order),
      [&](const LongVec3& xi, long double* v) { f(xi, e, v); });
  }
  return values;
}

ChebyshevModel Linear(double a, double s, double t)
{
  ChebyshevModel model(a);
  model.c[ChebyshevModel::Index(1, 0)] = s;
  model.c[ChebyshevModel::Index(0, 1)] = t;
  return model;
}

TEST(ClippedSquare, HoldsClosedForms)
{
  // Half of it by a diagonal, and of a density s^2: the triangle s <= t.
  const std::array diagonal{ Linear(0.0, 1.0, -1.0) };
  const auto half = ClippedSquare::Of(diagonal);
  ASSERT_TRUE(half);
  ExpectHolds(half->Integral(1.0), 2.0, 1e-9, "half");
  const ChebyshevModel s = ChebyshevModel::First();
  ExpectHolds(half->Integral(s * s), 2.0 / 3.0, 1e-9, "s^2 over half");
  EXPECT_NEAR(half->Part(), 0.5, 1e-9);

  // A strip 0.2 <= t <= 0.6 whose rims are of two functions.
  const std::array strip{ Linear(0.2, 0.0, -1.0), Linear(-0.6, 0.0, 1.0) };
  const auto between = ClippedSquare::Of(strip);
  ASSERT_TRUE(between);
  ExpectHolds(between->Integral(1.0), 0.8, 1e-9, "strip");

  // The same along s.
  const std::array along{ Linear(0.2, -1.0, 0.0) };
  const auto right = ClippedSquare::Of(along);
  ASSERT_TRUE(right);
  ExpectHolds(right->Integral(1.0), 1.6, 1e-9, "s >= 0.2");
  ExpectHolds(right->Integral(s), 0.96, 1e-9, "s over s >= 0.2");

  // The region below the parabola t = s^2 - 1/2, which leaves through the top.
  const ChebyshevModel parabola = ChebyshevModel::Second() - 2.0 * (s * s) + ChebyshevModel(0.5);
  const auto below = ClippedSquare::Of(std::span(&parabola, 1));
  ASSERT_TRUE(below);
  // The parabola is above 1 for |s| > sqrt(3) / 2.
  const double a = std::sqrt(3.0) / 2.0;
  const double area = 2.0 * (2.0 * a * a * a / 3.0 + 0.5 * a) + 4.0 * (1.0 - a);
  ExpectHolds(below->Integral(1.0), area, 1e-9, "parabola");

  const std::array none{ Linear(3.0, 1.0, 1.0) };
  EXPECT_TRUE(ClippedSquare::Of(none)->IsEmpty());
  const std::array all{ Linear(-3.0, 1.0, 1.0) };
  ExpectHolds(ClippedSquare::Of(all)->Integral(1.0), 4.0, 1e-12, "all");
  // A rim in the square's own side, up to rounding.
  const std::array side{ Linear(-1.0, 0.0, 1.0 + 1e-16) };
  ExpectHolds(ClippedSquare::Of(side)->Integral(1.0), 4.0, 1e-10, "side");
  // Boxes with crossing rims must be subdivided.
  const std::array corner{ Linear(0.0, 1.0, -1.0), Linear(0.0, 1.0, 1.0) };
  EXPECT_FALSE(ClippedSquare::Of(corner));
}

TEST(ClippedSquare, AgreesWithCounting)
{
  Random random(11);
  int known = 0;
  for (int trial = 0; trial < 30; ++trial)
  {
    ChebyshevModel rim = Linear(random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0));
    ChebyshevModel density(1.0);
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; i + j < 4; ++j)
      {
        rim.c[ChebyshevModel::Index(i, j)] += random(-0.05, 0.05);
        density.c[ChebyshevModel::Index(i, j)] += random(-0.3, 0.3);
      }
    }
    const auto clipped = ClippedSquare::Of(std::span(&rim, 1));
    if (!clipped)
    {
      continue;
    }
    ++known;
    const auto at = [](const ChebyshevModel& f, double s, double t)
    {
      double sum = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        for (int j = 0; i + j < 4; ++j)
        {
          sum += f.c[ChebyshevModel::Index(i, j)] * std::cos(i * std::acos(s)) *
            std::cos(j * std::acos(t));
        }
      }
      return sum;
    };
    constexpr int kRows = 400;
    double counted = 0.0;
    for (int i = 0; i < kRows; ++i)
    {
      for (int j = 0; j < kRows; ++j)
      {
        const double s = -1.0 + (2.0 * i + 1.0) / kRows;
        const double t = -1.0 + (2.0 * j + 1.0) / kRows;
        counted += at(rim, s, t) <= 0.0 ? at(density, s, t) : 0.0;
      }
    }
    EXPECT_NEAR(clipped->Integral(density).Middle(), counted * 4.0 / kRows / kRows, 2e-2);
    EXPECT_LT(clipped->Integral(density).Width(), 0.5);
  }
  EXPECT_GT(known, 20);
}

TEST(Integral, ABallsIsoSurface)
{
  // r^2 on a straight cube: its value 1/4 is a sphere of radius 1/2.
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = OnMesh(cube.View(), 2, 1,
    [](const LongVec3& x, int, long double* v) { v[0] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; });
  const Field squares{ "r2", values.View() };
  const IsoValueSurface ball(squares, 0, 0.25);
  const SurfaceIntegral found = Over(ball, cube.View(), &squares, 1e-4);
  EXPECT_TRUE(found.met);
  ExpectHolds(found.sums[0], kPi, 1e-3, "area");
  ExpectHolds(found.sums[1], kPi / 4.0, 1e-3, "r^2");

  // The flux of (x, 0, 0) along the gradient, which points outwards, is the ball's volume.
  const ExpansionBuilder linear = OnMesh(cube.View(), 1, 3,
    [](const LongVec3& x, int, long double* v)
    {
      v[0] = x[0];
      v[1] = v[2] = 0.0L;
    });
  const Field vector{ "v", linear.View() };
  const SurfaceIntegral flux = Over(ball, cube.View(), &vector, 1e-4);
  ExpectHolds(flux.sums.back(), kPi / 6.0, 1e-3, "flux");

  // Half of it, and a slice.
  const std::array upper{ PlaneForm({ 0, 0, -1 }, 0.0) };
  ExpectHolds(Over(ball, cube.View(), nullptr, 1e-4, upper).sums[0], kPi / 2.0, 1e-3, "half");
  const std::array slice{ PlaneForm({ 0, 0, -1 }, -0.1), PlaneForm({ 0, 0, 1 }, -0.2) };
  ExpectHolds(
    Over(ball, cube.View(), nullptr, 1e-4, slice).sums[0], 2.0 * kPi * 0.5 * 0.3, 1e-3, "slice");
}

TEST(Integral, AnIsoSurfaceOfCurvedElements)
{
  // The height of the bent cube over a plane, which its own space holds: the iso-surface is the
  // plane's cut.
  for (const Shape shape : kShapes)
  {
    const CurvedMesh curved = Blocks(1, std::span(&shape, 1));
    const Mesh mesh = curved.View();
    ExpansionBuilder heights(1);
    for (int e = 0; e < mesh.Elements(); ++e)
    {
      const Space& space = mesh.map.SpaceOf(e);
      const auto modes = static_cast<std::size_t>(space.Modes());
      heights.Add(space, [](const LongVec3&, long double* v) { v[0] = 0.0L; });
      const double* const map = mesh.map.Coefficients(e);
      const auto at = static_cast<std::size_t>(heights.Offset.back());
      const double size = mesh.size[static_cast<std::size_t>(e)];
      for (std::size_t m = 0; m < modes; ++m)
      {
        heights.Coefficients[at + m] = size * (map[m] + map[modes + m] + map[2 * modes + m]);
      }
      const double* const centre = &mesh.centre[3 * static_cast<std::size_t>(e)];
      heights.Coefficients[at] += centre[0] + centre[1] + centre[2];
    }
    const Field height{ "h", heights.View() };
    const IsoValueSurface iso(height, 0, 0.3);
    const PolynomialSurface plane(PlaneForm({ 1, 1, 1 }, -0.3));
    const SurfaceIntegral one = Over(iso, mesh, &height, 1e-4);
    const SurfaceIntegral other = Over(plane, mesh, &height, 1e-4);
    EXPECT_TRUE(one.met && other.met) << Name(shape);
    for (std::size_t q = 0; q < 2; ++q)
    {
      EXPECT_FALSE(Intersect(one.sums[q], other.sums[q]).IsEmpty()) << Name(shape) << " " << q;
    }
    // 4.95850 by counting in long double (TestIntegral.cxx).
    EXPECT_NEAR(one.sums[0].Middle(), 4.95850, 1e-3) << Name(shape);
  }
}

TEST(Integral, AMagnitudesIsoSurface)
{
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = OnMesh(cube.View(), 1, 3,
    [](const LongVec3& x, int, long double* v) { std::copy(x.begin(), x.end(), v); });
  const Field place{ "x", values.View() };
  const SurfaceIntegral found =
    Over(IsoValueSurface(place, IsoValueSurface::kOfMagnitude, 0.5), cube.View(), &place, 1e-4);
  ExpectHolds(found.sums[0], kPi, 1e-2, "area");
  ExpectHolds(found.sums.back(), 0.5 * kPi, 1e-2, "flux");
}

TEST(Integral, TheBoundaryValueIsTheBoundary)
{
  // 1 - z^2 vanishes on two faces of the element, and nowhere within.
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = OnMesh(
    cube.View(), 2, 1, [](const LongVec3& x, int, long double* v) { v[0] = 1.0L - x[2] * x[2]; });
  const Field field{ "w", values.View() };
  const SurfaceIntegral found = Over(IsoValueSurface(field, 0, 0.0), cube.View(), nullptr, 1e-6);
  EXPECT_EQ(found.faces, 2);
  ExpectHolds(found.sums[0], 8.0, 1e-5, "two faces");

  const ExpansionBuilder same =
    OnMesh(cube.View(), 1, 1, [](const LongVec3&, int, long double* v) { v[0] = 2.0L; });
  const Field constant{ "c", same.View() };
  const SurfaceIntegral flat = Over(IsoValueSurface(constant, 0, 2.0), cube.View(), nullptr, 1e-6);
  EXPECT_EQ(flat.flat, 1);
  EXPECT_EQ(flat.sums[0].upper, 0.0);
}

TEST(Integral, Tori)
{
  const MeshBuilder cube = Cube();
  const PolynomialSurface torus(
    ImplicitPolynomial::Torus({ 0.02, -0.01, 0.03 }, { 0.1, 0.2, 1.0 }, 0.6, 0.25));
  const SurfaceIntegral found = Over(torus, cube.View(), nullptr, 1e-2);
  EXPECT_TRUE(found.met);
  ExpectHolds(found.sums[0], 4.0 * kPi * kPi * 0.6 * 0.25, 3e-1, "torus");

  // The flux of the position is three times the volume.
  const ExpansionBuilder values = OnMesh(cube.View(), 1, 3,
    [](const LongVec3& x, int, long double* v) { std::copy(x.begin(), x.end(), v); });
  const Field place{ "x", values.View() };
  ExpectHolds(Over(torus, cube.View(), &place, 1e-2).sums.back(),
    3.0 * 2.0 * kPi * kPi * 0.6 * 0.25 * 0.25, 3e-1, "flux");
  EXPECT_THROW((void)ImplicitPolynomial::Torus(Vec3(0.0), Vec3(0.0), 1.0, 0.5), InvalidData);
  EXPECT_THROW((void)ImplicitPolynomial::Torus(Vec3(0.0), { 0, 0, 1 }, -1.0, 0.5), InvalidData);
}

TEST(Integral, DiscsAndRectangles)
{
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = OnMesh(cube.View(), 2, 1,
    [](const LongVec3& x, int, long double* v) { v[0] = x[0] * x[0] + x[1] * x[1]; });
  const Field field{ "u", values.View() };
  const PolynomialSurface plane(PlaneForm({ 0, 0, 1 }, -0.25));
  const std::array disc{ ImplicitPolynomial::Sphere({ 0, 0, 0.25 }, 0.5) };
  const SurfaceIntegral round = Over(plane, cube.View(), &field, 1e-7, disc);
  EXPECT_TRUE(round.met);
  ExpectHolds(round.sums[0], kPi / 4.0, 1e-6, "disc");
  ExpectHolds(round.sums[1], kPi / 32.0, 1e-6, "x^2 + y^2 on it");

  const std::array rectangle{ PlaneForm({ 1, 0.1, 0 }, -0.5), PlaneForm({ -1, -0.1, 0 }, -0.3),
    PlaneForm({ -0.1, 1, 0 }, -0.4), PlaneForm({ 0.1, -1, 0 }, -0.2) };
  const SurfaceIntegral tilted = Over(plane, cube.View(), nullptr, 1e-7, rectangle);
  EXPECT_TRUE(tilted.met);
  ExpectHolds(tilted.sums[0], 0.8 * 0.6 / 1.01, 1e-6, "a turned rectangle");

  // Rims in the element's own faces, and beyond all of it.
  const std::array outside{ PlaneForm({ 1, 0, 0 }, -1.0), PlaneForm({ 0, 1, 0 }, 0.0),
    PlaneForm({ 0, -1, 0 }, -7.0) };
  ExpectHolds(Over(plane, cube.View(), nullptr, 1e-7, outside).sums[0], 2.0, 1e-6, "in faces");
  const std::array nothing{ PlaneForm({ 1, 0, 0 }, 2.0) };
  EXPECT_EQ(Over(plane, cube.View(), nullptr, 1e-7, nothing).sums[0].upper, 0.0);
}

TEST(Integral, FacesAreClippedToo)
{
  const MeshBuilder cube = Cube();
  const std::array half{ PlaneForm({ 1, 0.2, 0.3 }, 0.0) };
  const IntegralQuestion question{ cube.View(), nullptr, nullptr, half };
  std::vector<ElementFace> faces;
  for (int f = 0; f < 6; ++f)
  {
    faces.push_back({ 0, f });
  }
  IntegralEffort effort;
  effort.tolerance = 1e-6;
  // Half of all six, for the plane runs through the middle.
  ExpectHolds(IntegrateFaces(question, faces, effort).sums[0], 12.0, 1e-4, "half of the faces");
}

TEST(Integral, WrongIsoSurfacesAreRefused)
{
  const MeshBuilder cube = Cube();
  const ExpansionBuilder values = OnMesh(cube.View(), 1, 3,
    [](const LongVec3& x, int, long double* v) { std::copy(x.begin(), x.end(), v); });
  const Field place{ "x", values.View() };
  EXPECT_THROW(IsoValueSurface(place, 3, 0.5), InvalidData);
  EXPECT_THROW(IsoValueSurface(place, 0, std::nan("")), InvalidData);
  EXPECT_THROW(IsoValueSurface(place, IsoValueSurface::kOfMagnitude, 0.0), InvalidData);
  const Field mapped{ "x", values.View(), Mapping::Contravariant };
  EXPECT_THROW(IsoValueSurface(mapped, 0, 0.5), Unsupported);
}
} // namespace
} // namespace pixelexact::testing
