// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ClippedPieces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
class PieceClipper
{
public:
  PieceClipper(const ImplicitPolynomial& clip, CurveEvaluator& evaluator, double tolerance)
    : Clip(clip)
    , Evaluator(evaluator)
    , Tolerance(tolerance)
  {
  }

  /// Appends the parts that are kept.
  void Keep(CurvePiece piece, std::vector<CurvePiece>& kept)
  {
    if (!piece.closed)
    {
      KeepOpen(piece, kept);
      return;
    }
    const auto firstCut =
      std::ranges::find_if(piece.points, [this](const CurvePoint& at) { return IsCut(at); });
    const bool isWhole = firstCut == piece.points.end();
    std::rotate(
      piece.points.begin(), isWhole ? piece.points.begin() : firstCut, piece.points.end());
    piece.points.push_back(piece.points.front());
    KeepOpen(piece, kept);
    if (isWhole)
    {
      kept.back().points.pop_back();
      kept.back().closed = true;
    }
  }

private:
  [[nodiscard]] double ValueAt(const CurvePoint& point) const
  {
    return Clip.ValueAround(point.x - Clip.origin);
  }
  [[nodiscard]] bool IsCut(const CurvePoint& point) const { return ValueAt(point) > 0.0; }

  /// Whether the clip has one sign on a chord, or changes monotonically along it.
  [[nodiscard]] bool IsClear(const CurvePoint& a, const CurvePoint& b) const
  {
    const double atA = ValueAt(a);
    const double atB = ValueAt(b);
    const Vec3 gradientA = Clip.GradientAround(a.x - Clip.origin);
    const Vec3 gradientB = Clip.GradientAround(b.x - Clip.origin);
    const double slopeA = glm::dot(gradientA, b.x - a.x);
    const double slopeB = glm::dot(gradientB, b.x - a.x);
    // Where the slopes differ in sign, the clip may rise or fall by a fraction of one of them.
    const double slack = Tolerance * std::max(glm::length(gradientA), glm::length(gradientB)) +
      std::min(std::fabs(slopeA), std::fabs(slopeB));
    return (slopeA * slopeB > 0.0 && slopeA * (atB - atA) > 0.0) || std::max(atA, atB) < -slack ||
      std::min(atA, atB) > slack;
  }

  /// The point of the curve between two points where the clip vanishes; none where it is not found.
  [[nodiscard]] std::optional<CurvePoint> Crossing(const CurvePoint& inside, const CurvePoint& cut)
  {
    const Vec3 along = cut.xi - inside.xi;
    CurvePoint found = inside;
    double lower = 0.0;
    double upper = 1.0;
    while (upper - lower > 1e-15)
    {
      const double t = 0.5 * (lower + upper);
      const Vec3 at = inside.xi + t * along;
      const auto point = Evaluator.InPlane(at, { along, glm::dot(along, at) }, glm::length(along));
      if (!point)
      {
        return std::nullopt;
      }
      const bool isInside = !IsCut(*point);
      (isInside ? lower : upper) = t;
      found = isInside ? *point : found;
    }
    return found;
  }

  void KeepOpen(const CurvePiece& piece, std::vector<CurvePiece>& kept)
  {
    CurvePiece part;
    const auto begin = [&](bool clipped) {
      part = { {}, false, piece.lost, piece.certain, { clipped, true } };
    };
    const auto finish = [&]
    {
      // A point on the clip alone is no line.
      if (part.points.size() > 2 || part.points.front().xi != part.points.back().xi)
      {
        kept.push_back(std::move(part));
      }
    };
    const auto addCrossing = [&](const CurvePoint& inside, const CurvePoint& cut)
    {
      const auto crossing = Crossing(inside, cut);
      part.lost = part.lost || !crossing;
      part.certain = part.certain && crossing && IsClear(inside, cut);
      part.points.push_back(crossing.value_or(inside));
    };
    for (std::size_t i = 0; i < piece.points.size(); ++i)
    {
      const CurvePoint& point = piece.points[i];
      const CurvePoint* const before = i > 0 ? &piece.points[i - 1] : nullptr;
      const bool wasCut = before == nullptr || IsCut(*before);
      if (!IsCut(point))
      {
        if (wasCut)
        {
          begin(before != nullptr || piece.clipped[0]);
        }
        if (wasCut && before != nullptr)
        {
          addCrossing(point, *before);
        }
        part.certain = part.certain && (wasCut || IsClear(*before, point));
        part.points.push_back(point);
      }
      else if (!wasCut)
      {
        addCrossing(*before, point);
        finish();
      }
    }
    if (!IsCut(piece.points.back()))
    {
      part.clipped[1] = piece.clipped[1];
      finish();
    }
  }

  const ImplicitPolynomial& Clip;
  CurveEvaluator& Evaluator;
  double Tolerance;
};
} // namespace

std::vector<CurvePiece> ClipPieces(std::vector<CurvePiece> pieces, const ContourQuestion& question,
  CurveEvaluator& evaluator, double tolerance)
{
  for (const ImplicitPolynomial& clip : question.clips)
  {
    std::vector<CurvePiece> kept;
    PieceClipper clipper(clip, evaluator, tolerance);
    for (CurvePiece& piece : pieces)
    {
      clipper.Keep(std::move(piece), kept);
    }
    pieces = std::move(kept);
  }
  return pieces;
}
} // namespace pixelexact
