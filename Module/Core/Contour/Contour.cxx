// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/Contour.h"

#include "Core/Base/Error.h"
#include "Core/Contour/FaceOwner.h"
#include "Core/Contour/LineAssembly.h"
#include "Core/Faces/FacePlane.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr double kOnFace = 1e-9;

void Check(const ContourRequest& request)
{
  for (const double value : request.values)
  {
    if (!std::isfinite(value))
    {
      throw InvalidData(
        "contours of the value " + std::to_string(value) + " were asked for; give finite values.");
    }
  }
  if (!(request.tolerance > 0.0 && std::isfinite(request.tolerance)))
  {
    throw InvalidData("the tolerance of contours must be greater than 0, in world units.");
  }
}

/// Whether a piece lies in a face that the surface contains, and another element draws it.
bool IsAnothers(const CurvePiece& piece, const ElementContour& contour, const Mesh& mesh,
  const FaceOwner& owner, int element)
{
  return std::ranges::any_of(contour.heldFaces,
    [&](int face)
    {
      const FacePlane& plane = FacePlanesOf(mesh.ShapeOf(element))[static_cast<std::size_t>(face)];
      return std::ranges::all_of(piece.points,
               [&](const CurvePoint& point)
               { return std::fabs(plane.Distance(point.xi)) <= kOnFace; }) &&
        owner.IsAnothers(element, face, piece.points[piece.points.size() / 2]);
    });
}
} // namespace

ContourSet TraceContours(const ContourQuestion& question, const Locator& locator,
  const FaceTable& faces, const ContourRequest& request)
{
  Check(request);
  ContourSet set;
  const auto count = static_cast<std::size_t>(question.mesh.Elements());
  const auto values = request.values.size();
  std::vector<ElementContour> found(count * values);
  const auto trace = [&](std::size_t e)
  {
    const auto element = static_cast<int>(e);
    const CurveEquations equations(question, element);
    for (std::size_t v = 0; v < values; ++v)
    {
      // The norm of a vector is 0 at points.
      if (!question.IsMagnitude() || request.values[v] > 0.0)
      {
        found[v * count + e] =
          TraceElement(question, equations, element, request.values[v], request.tolerance);
      }
    }
  };
  if (question.cut->NeedsCallingThread())
  {
    for (std::size_t e = 0; e < count; ++e)
    {
      trace(e);
    }
  }
  else
  {
    tbb::parallel_for(std::size_t{ 0 }, count, trace);
  }

  const FaceOwner owner(locator, faces);
  ContourReport& report = set.report;
  for (std::size_t v = 0; v < values; ++v)
  {
    report.normsOfZero += question.IsMagnitude() && request.values[v] == 0.0 ? 1 : 0;
    std::vector<PlacedPiece> pieces;
    for (std::size_t e = 0; e < count; ++e)
    {
      const auto element = static_cast<int>(e);
      ElementContour& contour = found[v * count + e];
      report.elements += contour.mayBe ? 1 : 0;
      report.undecided += contour.complete ? 0 : 1;
      report.constant += contour.constant ? 1 : 0;
      report.notFinite += contour.notFinite && v == 0 ? 1 : 0;
      report.tooHigh += contour.tooHigh ? 1 : 0;
      for (CurvePiece& piece : contour.pieces)
      {
        if (!IsAnothers(piece, contour, question.mesh, owner, element))
        {
          ++report.pieces;
          report.unproven += piece.certain ? 0 : 1;
          report.lost += piece.lost ? 1 : 0;
          pieces.push_back({ element, std::move(piece), contour.complete });
        }
      }
    }
    AssembleLines(question.mesh, faces, std::move(pieces), v, set);
  }
  return set;
}
} // namespace pixelexact
