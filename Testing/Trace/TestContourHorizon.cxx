// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on pixels whose rays miss a plane, or meet it beyond the mesh: above its horizon, behind
// the eye, and along it.
#include "BentCube.h"

#include "Trace/Contours/LayerBounds.h"
#include "Trace/TileVisit.h"

namespace pixelexact::testing
{
namespace
{
ContourCounters CertifyPlane(const CameraView& view, const ContourMethod& method = {})
{
  const TrueVerdicts truth(
    SightOf(view, kVerdictWidth, kVerdictHeight, PlaneHits(kPlaneOrigin, kPlaneNormal),
      [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); }),
    kVerdictWidth, kVerdictHeight, kContourValues, kValueTolerance);
  const std::vector<Shape> shapes{ Shape::Hexahedron };
  const BentCube cube(shapes);
  ContourCertifier certifier({ kContourValues }, method);
  Trace(cube.With(std::make_shared<Plane>(kPlaneOrigin, kPlaneNormal)),
    Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
  truth.Check(certifier.Verdicts(), true);
  return certifier.Counters();
}

/// A view from outside the cube, low above the plane, with a third of the image empty.
CameraView OverThePlane()
{
  CameraView view;
  view.position = { -2.5, 0.3, 0.9 };
  view.focalPoint = { 1.0, 0.0, 0.2 };
  view.viewUp = { 0.0, 0.0, 1.0 };
  view.viewAngle = 60.0;
  return view;
}
} // namespace

TEST(ContourHorizon, SkyIsOut)
{
  for (const bool interior : { false, true })
  {
    ContourMethod method;
    method.interior = interior;
    const ContourCounters counters = CertifyPlane(OverThePlane(), method);
    EXPECT_GT(counters.in, 100) << interior;
    EXPECT_LE(counters.undecided, 1) << interior;
  }
}

TEST(ContourHorizon, EyesInTheMeshSeeWhatIsAhead)
{
  CameraView view = OverThePlane();
  view.position = { 0.1, 0.2, 0.4 };
  view.focalPoint = { 1.0, 0.1, 0.3 };
  const ContourCounters counters = CertifyPlane(view);
  EXPECT_GT(counters.in, 10);
  EXPECT_LE(counters.undecided, 1);
}

TEST(ContourHorizon, WhatIsBehindAParallelEyeIsOut)
{
  CameraView view = OverThePlane();
  view.position = { 0.0, 0.1, 0.2 };
  view.focalPoint = { 1.0, 0.0, -0.9 };
  view.parallel = true;
  view.parallelScale = 1.5;
  const ContourCounters counters = CertifyPlane(view);
  EXPECT_GT(counters.in, 50);
  // Undecided pixels lie along the horizon of the plane.
  EXPECT_LE(counters.undecided, 10);
}

TEST(ContourHorizon, PlanesAlongTheViewAreOut)
{
  CameraView view;
  view.position = { -5.0, 0.0, 0.0 };
  view.viewUp = { 0.0, 0.0, 1.0 };
  view.parallel = true;
  const std::vector<Shape> shapes{ Shape::Hexahedron };
  const BentCube cube(shapes);
  ContourCertifier certifier({ kContourValues });
  Trace(cube.With(std::make_shared<Plane>(Vec3(0.0), Vec3(0.0, 0.0, 1.0))),
    Camera(view, kVerdictWidth, kVerdictHeight), { {}, { &certifier } });
  EXPECT_EQ(certifier.Counters().out, kVerdictWidth * kVerdictHeight);
}
} // namespace pixelexact::testing
