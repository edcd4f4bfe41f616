// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/TouchedLines.h"

#include "Core/Contour/SeedList.h"
#include "Core/Faces/FacePlane.h"
#include "Core/Math/Mat.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace pixelexact
{
namespace
{
/// The number of directions that are tried in an element. Neighbouring lines have the same
/// direction.
constexpr int kDirections = 16;

/// The direction of the image of a matrix of rank 1; none where the matrix is zero or not finite.
std::optional<Vec3> ImageOf(const Mat3& matrix)
{
  Vec3 longest = matrix[0];
  for (const int d : { 1, 2 })
  {
    longest = glm::length(matrix[d]) > glm::length(longest) ? matrix[d] : longest;
  }
  const double length = glm::length(longest);
  return length > 0.0 && std::isfinite(length) ? std::optional(longest / length) : std::nullopt;
}
} // namespace

std::vector<CurvePiece> FindTouchedLines(const ContourQuestion& question, int element, double value,
  std::span<const OpenPlace> open, const TraceLimits& limits)
{
  const Shape shape = question.mesh.ShapeOf(element);
  const auto planes = FacePlanesOf(shape);
  std::vector<OpenPlace> places(open.begin(), open.end());
  std::vector<CurvePiece> lines;
  for (int round = 0; round < kDirections && !places.empty(); ++round)
  {
    CurveEvaluator evaluator(question, element, value);
    const auto along = ImageOf(evaluator.TurnByXi(places.front().xi));
    if (!along)
    {
      places.erase(places.begin());
      continue;
    }
    const std::size_t before = places.size();
    evaluator.FollowTurn(*along);
    const auto isTouched = [&](const CurvePoint& point)
    { return std::fabs(point.value - value) <= 2.0 * evaluator.Rounding(); };
    SeedList list(shape, false, 0);
    std::erase_if(places,
      [&](const OpenPlace& place)
      {
        std::optional<CurvePoint> point;
        if (place.faces == 0)
        {
          point = evaluator.Near(place.xi, kNear);
        }
        else
        {
          const FacePlane& face = planes[static_cast<std::size_t>(std::countr_zero(place.faces))];
          point = evaluator.InPlane(place.xi, { face.gradient, -face.constant }, kNear);
        }
        const bool found = point && point->IsRegular() && isTouched(*point);
        if (found)
        {
          list.AddUndecided(point, place.faces, place.xi);
        }
        return found;
      });
    if (places.size() == before)
    {
      places.erase(places.begin());
    }
    CurveTracer tracer(evaluator, shape, limits, {});
    for (CurvePiece& piece : tracer.TraceAll(list.result.seeds))
    {
      if (!piece.lost && std::ranges::all_of(piece.points, isTouched))
      {
        lines.push_back(std::move(piece));
      }
    }
  }
  return lines;
}
} // namespace pixelexact
