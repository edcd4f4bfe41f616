// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ElementContour.h"

#include "Core/Contour/ArcProof.h"
#include "Core/Contour/ClippedPieces.h"
#include "Core/Contour/TouchedLines.h"

#include <algorithm>
#include <iterator>

namespace pixelexact
{
namespace
{
/// The longest chord, in units of the element's size.
constexpr double kLongest = 0.25;

void Prove(const CurveEquations& equations, CurveEvaluator& evaluator, Shape shape, double value,
  const std::vector<ContourSeed>& seeds, std::vector<CurvePiece>& pieces)
{
  std::vector<Vec3> crossings;
  for (const ContourSeed& seed : seeds)
  {
    if (seed.onBoundary)
    {
      crossings.push_back(ReferenceToTensor(shape, seed.point.xi));
    }
  }
  ArcProof proof(equations, evaluator, shape, value, std::move(crossings));
  for (CurvePiece& piece : pieces)
  {
    std::vector<CurvePoint> points = piece.points;
    if (piece.closed)
    {
      points.push_back(points.front());
    }
    piece.certain = !piece.lost && proof.Holds(points);
  }
}
} // namespace

ElementContour TraceElement(const ContourQuestion& question, const CurveEquations& equations,
  int element, double value, double tolerance, const ContourEffort& effort)
{
  ElementContour contour;
  contour.tooHigh = equations.IsTooHigh();
  if (contour.tooHigh)
  {
    contour.complete = false;
    return contour;
  }
  const Shape shape = question.mesh.ShapeOf(element);
  CurveEvaluator evaluator(question, element, value);
  SeedSearchResult search = FindContourSeeds(equations, evaluator, shape, value, effort.seeds);
  contour.complete = search.complete && equations.IsExact();
  contour.constant = search.constant;
  contour.heldFaces = search.heldFaces;
  contour.spent = search.spent;
  const TraceLimits limits{ tolerance,
    kLongest * question.mesh.size[static_cast<std::size_t>(element)], effort.steps };
  std::vector<CurvePiece> touched = FindTouchedLines(question, element, value, search.open, limits);
  contour.touched = std::ssize(touched);
  CurveTracer tracer(evaluator, shape, limits, search.heldFaces);
  contour.pieces = tracer.TraceAll(search.seeds);
  contour.spent = contour.spent || tracer.IsSpent();
  contour.complete = contour.complete && !contour.spent;
  std::ranges::move(touched, std::back_inserter(contour.pieces));
  if (contour.complete)
  {
    Prove(equations, evaluator, shape, value, search.seeds, contour.pieces);
  }
  contour.pieces = ClipPieces(std::move(contour.pieces), question, evaluator, tolerance);
  return contour;
}
} // namespace pixelexact
