// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on faces and iso-surfaces against many samples of closed forms.
#include "BentCube.h"
#include "CurvedCheck.h"

#include "Trace/TileVisit.h"

namespace pixelexact::testing
{
namespace
{
const std::vector<double> kValues{ -2.0, -0.7, -0.1, 0.05, 0.4, 1.1 };
constexpr long double kTolerance = 1e-11L;

/// Shows all of the cube.
CameraView FromAfar(bool parallel)
{
  CameraView view = Oblique(parallel);
  view.position = { 1.9, -2.9, 6.0 };
  view.parallelScale = 1.9;
  return view;
}

const std::vector<std::vector<Shape>> kMeshes{ { Shape::Hexahedron }, { Shape::Tetrahedron },
  { std::begin(kShapes), std::end(kShapes) } };

ContourCounters JudgeAndCheck(const Scene& scene, const CameraView& view, const TrueVerdicts& truth)
{
  ContourCertifier certifier({ kValues });
  Trace(scene, Camera(view, kWidth, kHeight), { {}, { &certifier } });
  truth.Check(certifier.Verdicts(), false);
  const ContourCounters& counters = certifier.Counters();
  std::cout << counters.in << " in, " << counters.undecided << " undecided\n";
  EXPECT_GT(counters.in, 150);
  return counters;
}
} // namespace

/// The boundary of the bent cube: curved faces, and the edges between them.
TEST(ContourFaces, NoVerdictOnABoundaryIsWrong)
{
  for (const bool parallel : { false, true })
  {
    const CameraView view = FromAfar(parallel);
    const TrueVerdicts truth(
      [&](long double px, long double py) -> std::optional<TrueSight>
      {
        const auto point = MeetBentCube(RayThrough(view, kWidth, kHeight, px, py));
        return point ? std::optional(TrueSight{ 0, Quadratic(Bend(point->u)) }) : std::nullopt;
      },
      kWidth, kHeight, kValues, kTolerance);
    for (const auto& shapes : kMeshes)
    {
      if (parallel && shapes.size() == 1)
      {
        continue;
      }
      SCOPED_TRACE(::testing::Message()
        << (parallel ? "parallel, " : "") << Name(shapes.front()) << " of " << shapes.size());
      const BentCube cube(shapes);
      const ElementIndex& index = cube.TheLocator.Index();
      const ContourCounters counters = JudgeAndCheck(
        cube.With(std::make_shared<ElementFaces>(index, BoundaryOf(index))), view, truth);
      EXPECT_LE(counters.undecided, 100);
    }
  }
}

/// A sphere, as an iso-surface of another field.
TEST(ContourFaces, NoVerdictOnAnIsoSurfaceIsWrong)
{
  constexpr double kRadius = 0.75;
  for (const bool parallel : { false, true })
  {
    const CameraView view = FromAfar(parallel);
    const TrueVerdicts truth(
      SightOf(view, kWidth, kHeight, RoundHits(Vec3(0.0), Vec3(0.0), kRadius),
        [](const LongVec3& x, const LongVec3& /*u*/) { return Quadratic(x); }),
      kWidth, kHeight, kValues, kTolerance);
    for (const auto& shapes : kMeshes)
    {
      if (parallel && shapes.size() == 1)
      {
        continue;
      }
      SCOPED_TRACE(::testing::Message()
        << (parallel ? "parallel, " : "") << Name(shapes.front()) << " of " << shapes.size());
      const BentCube cube(shapes);
      const ExpansionBuilder values =
        cube.FieldOf([](const LongVec3& x, int /*element*/) { return Dot(x, x); });
      const Field field{ "square", values.View() };
      const ContourCounters counters = JudgeAndCheck(
        cube.With(
          std::make_shared<IsoSurface>(cube.TheLocator.Index(), field, 0, kRadius * kRadius)),
        view, truth);
      EXPECT_LE(counters.undecided, 50);
    }
  }
}
} // namespace pixelexact::testing
