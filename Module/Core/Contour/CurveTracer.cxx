// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CurveTracer.h"

#include "Core/Contour/SeedList.h"
#include "Core/Faces/FacePlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr double kTurn = 0.94;      ///< cosine of the angle by which a step may turn
constexpr double kSameBranch = 0.8; ///< cosine to a point that a step passes
constexpr double kAside = 0.2;      ///< of a step: how far its curve may pass beside a seed's place
constexpr double kShare = 0.7;      ///< of the tolerance that a step may use
constexpr double kShortest = 1e-12; ///< of the longest step
constexpr double kTracedOnFace = 1e-13; ///< distance to a face's plane, in xi
constexpr double kGrazing = 1e-6;       ///< of the angle to a face that is touched
constexpr double kPassesSeed = 1e-10;   ///< a curve passes a seed, in xi

double DistanceToChord(const Vec3& x, const Vec3& from, const Vec3& to)
{
  const Vec3 chord = to - from;
  const double square = glm::dot(chord, chord);
  const double t = square > 0.0 ? std::clamp(glm::dot(x - from, chord) / square, 0.0, 1.0) : 0.0;
  return glm::length(x - (from + t * chord));
}
/// Bounds how far the cubic with the curve's directions at the ends leaves the chord: with a chord
/// of length L at angles with the tangents m and n, the distance is L (m t (1-t)^2 - n t^2 (1-t)).
double CubicBulge(const CurvePoint& from, const CurvePoint& to)
{
  const Vec3 chord = to.x - from.x;
  const auto slope = [&chord](const Vec3& along)
  { return glm::length(glm::cross(chord, along)) / glm::length(along); };
  return 4.0 / 27.0 * (slope(from.worldDirection) + slope(to.worldDirection));
}
} // namespace

CurveTracer::CurveTracer(
  CurveEvaluator& evaluator, Shape shape, const TraceLimits& limits, std::vector<int> heldFaces)
  : Evaluator(evaluator)
  , shape_(shape)
  , Limits(limits)
  , HeldFaces(std::move(heldFaces))
{
}

bool CurveTracer::IsOn(std::size_t face, const ContourSeed& seed) const
{
  return (seed.faces >> face & 1U) != 0 ||
    std::fabs(FacePlanesOf(shape_)[face].Distance(seed.point.xi)) <= kTracedOnFace;
}

int CurveTracer::Inward(const ContourSeed& seed) const
{
  const auto planes = FacePlanesOf(shape_);
  bool may[2] = { true, true };
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    if (!IsOn(k, seed) || std::ranges::find(HeldFaces, static_cast<int>(k)) != HeldFaces.end())
    {
      continue;
    }
    const double away = glm::dot(planes[k].gradient, seed.point.direction);
    may[0] = may[0] && away > 0.0;
    may[1] = may[1] && away < 0.0;
  }
  return may[0] == may[1] ? 0 : may[0] ? 1 : -1;
}

bool CurveTracer::IsGrazing(const ContourSeed& seed) const
{
  const auto planes = FacePlanesOf(shape_);
  bool parallel = true;
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    parallel = parallel &&
      (!IsOn(k, seed) || std::fabs(glm::dot(planes[k].gradient, seed.point.direction)) <= kGrazing);
  }
  return parallel;
}

std::optional<CurveTracer::Step> CurveTracer::Try(const CurvePoint& from, double length, int sense)
{
  const Vec3 move = sense * length / glm::length(from.worldDirection) * from.direction;
  const double reach = glm::length(move);
  const Vec3 ahead = from.xi + move;
  const auto to = Evaluator.InPlane(ahead, { move, glm::dot(move, ahead) }, 0.5 * reach);
  if (!to || !to->IsRegular() || glm::dot(to->direction, from.direction) < kTurn ||
    glm::dot(to->worldDirection, from.worldDirection) <
      kTurn * glm::length(to->worldDirection) * glm::length(from.worldDirection))
  {
    return std::nullopt;
  }
  const Vec3 chord = to->xi - from.xi;
  const Vec3 half = (from.xi + to->xi) / 2.0;
  const auto middle = Evaluator.InPlane(half, { chord, glm::dot(chord, half) }, 0.5 * reach);
  if (!middle || glm::dot(middle->direction, from.direction) < kSameBranch)
  {
    return std::nullopt;
  }
  const double sagitta = std::max(DistanceToChord(middle->x, from.x, to->x), CubicBulge(from, *to));
  if (!(sagitta <= kShare * Limits.tolerance))
  {
    return std::nullopt;
  }
  return Step{ *to, *middle, sagitta };
}

std::optional<CurveTracer::Passed> CurveTracer::FirstPassed(const std::vector<ContourSeed>& seeds,
  std::size_t first, bool mayClose, const CurvePoint& from, const Step& step, double after)
{
  const Vec3 chord = step.point.xi - from.xi;
  const double square = glm::dot(chord, chord);
  const double bulge = glm::length(step.middle.xi - (from.xi + step.point.xi) / 2.0);
  Passed best;
  for (std::size_t k = 0; k < seeds.size(); ++k)
  {
    const Vec3& at = seeds[k].point.xi;
    const double t = glm::dot(at - from.xi, chord) / square;
    if ((k == first && !mayClose) || (k != first && seeds[k].used) || !(t > after) ||
      !(t < best.part) || !(t <= 1.0 + 1e-9) ||
      glm::length(at - (from.xi + t * chord)) > 2.0 * bulge + kAside * std::sqrt(square))
    {
      continue;
    }
    // Starts on the parabola through both ends and the middle.
    const Vec3 bend = 4.0 * t * (1.0 - t) * (step.middle.xi - (from.xi + step.point.xi) / 2.0);
    const auto there = Evaluator.InPlane(from.xi + t * chord + bend, { chord, glm::dot(chord, at) },
      kAside * std::sqrt(square) + kPassesSeed);
    // Beside another branch, the value rises to the other side: the curve's direction is reversed.
    if (there && glm::length(there->xi - at) <= kPassesSeed &&
      glm::dot(there->direction, from.direction) > kSameBranch)
    {
      best = { k, t };
    }
  }
  return best.part < 2.0 ? std::optional(best) : std::nullopt;
}

std::optional<CurvePoint> CurveTracer::Exit(const CurvePoint& from, const CurvePoint& to)
{
  // Through the plane that the chord meets first.
  double first = 1.0;
  const FacePlane* through = nullptr;
  for (const FacePlane& plane : FacePlanesOf(shape_))
  {
    const double before = plane.Distance(from.xi);
    const double behind = plane.Distance(to.xi);
    if (behind < kOutside && before / (before - behind) < first)
    {
      first = before / (before - behind);
      through = &plane;
    }
  }
  return through == nullptr
    ? std::nullopt
    : Evaluator.InPlane(from.xi + first * (to.xi - from.xi),
        { through->gradient, -through->constant }, glm::length(to.xi - from.xi));
}

CurveTracer::End CurveTracer::Follow(
  std::vector<ContourSeed>& seeds, std::size_t first, int sense, std::vector<CurvePoint>& points)
{
  double length = Limits.longest;
  bool mayClose = false;
  while (Limits.steps-- > 0)
  {
    const CurvePoint from = points.back();
    auto step = Try(from, length, sense);
    while (!step && length > kShortest * Limits.longest)
    {
      length *= 0.5;
      step = Try(from, length, sense);
    }
    if (!step)
    {
      return End::Lost;
    }
    double after = 0.0;
    for (auto passed = FirstPassed(seeds, first, mayClose, from, *step, after); passed;
         passed = FirstPassed(seeds, first, mayClose, from, *step, after))
    {
      if (passed->seed == first)
      {
        return End::Closed;
      }
      ContourSeed& seed = seeds[passed->seed];
      seed.used = true;
      points.push_back(seed.point);
      // A seed in a corner or on an edge may be passed along the boundary.
      if (seed.onBoundary && Inward(seed) != sense)
      {
        return End::Crossing;
      }
      after = passed->part;
    }
    if (Margin(shape_, step->point.xi) < kOutside)
    {
      if (const auto exit = Exit(from, step->point))
      {
        points.push_back(*exit);
      }
      return End::Lost;
    }
    points.push_back(step->point);
    mayClose = true;
    const double used = step->sagitta / (kShare * Limits.tolerance);
    length = std::min(
      Limits.longest, length * (used > 0.05 ? std::clamp(0.9 / std::sqrt(used), 0.3, 2.0) : 2.0));
  }
  return End::Lost;
}

std::vector<CurvePiece> CurveTracer::TraceAll(std::vector<ContourSeed>& seeds)
{
  std::vector<CurvePiece> pieces;
  const auto keep = [&pieces](CurvePiece&& piece)
  {
    const Vec3& start = piece.points.front().xi;
    if (std::ranges::any_of(piece.points,
          [&](const CurvePoint& point) { return glm::length(point.xi - start) > kTracedOnFace; }))
    {
      pieces.push_back(std::move(piece));
    }
  };
  for (ContourSeed& seed : seeds)
  {
    // A curve that touches a face from inside continues.
    seed.onBoundary = seed.onBoundary && (!HeldFaces.empty() || !IsGrazing(seed));
  }
  for (std::size_t k = 0; k < seeds.size(); ++k)
  {
    if (seeds[k].used || !seeds[k].onBoundary)
    {
      continue;
    }
    const int sense = Inward(seeds[k]);
    seeds[k].used = true;
    if (sense == 0)
    {
      continue; // it touches the element there
    }
    CurvePiece piece;
    piece.points.push_back(seeds[k].point);
    piece.lost = Follow(seeds, k, sense, piece.points) != End::Crossing;
    keep(std::move(piece));
  }
  for (std::size_t k = 0; k < seeds.size(); ++k)
  {
    if (seeds[k].used)
    {
      continue;
    }
    seeds[k].used = true;
    CurvePiece piece;
    piece.points.push_back(seeds[k].point);
    piece.closed = Follow(seeds, k, 1, piece.points) == End::Closed;
    if (!piece.closed)
    {
      std::vector<CurvePoint> back{ seeds[k].point };
      Follow(seeds, k, -1, back);
      std::ranges::reverse(piece.points);
      piece.points.insert(piece.points.end(), back.begin() + 1, back.end());
      piece.lost = true;
    }
    keep(std::move(piece));
  }
  return pieces;
}
} // namespace pixelexact
