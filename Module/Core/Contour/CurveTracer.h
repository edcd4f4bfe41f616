// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourSeeds.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// A part of a contour in one element, from one crossing with its boundary to another, or closed.
struct CurvePiece
{
  std::vector<CurvePoint> points; ///< a closed one's last is next to its first, not the same
  bool closed = false;
  bool lost = false;             ///< an end is no crossing: there it could not be followed
  bool certain = false;          ///< proven: its ends, its course, and that there are no others
  std::array<bool, 2> clipped{}; ///< whether its first and its last point are where a clip ends it
};

struct TraceLimits
{
  double tolerance = 0.0; ///< world units: how far chords may be from the curve
  double longest = 0.0;   ///< world units: of a chord
  int steps = 0;          ///< of all pieces together
};

/// Follows the contours of an element from seed to seed, which it marks as used.
///
/// A step moves along the tangent, then Newton's iteration solves in the plane normal to the step.
/// It is kept if the tangent turned by less than 20 degrees and the sagitta is at most 0.7 times
/// the tolerance. The sagitta is the larger of two estimates, neither a bound: the distance to the
/// chord of the curve's point over its middle, found by the same iteration, and that of the cubic
/// with the curve's ends and tangents, which detects an inflexion. A step passes a seed if the
/// curve's point in the plane through the seed is the seed.
class CurveTracer
{
public:
  CurveTracer(
    CurveEvaluator& evaluator, Shape shape, const TraceLimits& limits, std::vector<int> heldFaces);

  /// All pieces: those that end on the boundary, then closed ones.
  std::vector<CurvePiece> TraceAll(std::vector<ContourSeed>& seeds);
  /// Whether a piece is lost because the budget of steps was exhausted.
  [[nodiscard]] bool IsSpent() const { return Limits.steps <= 0; }

private:
  struct Step
  {
    CurvePoint point;
    CurvePoint middle;
    double sagitta = 0.0;
  };
  struct Passed
  {
    std::size_t seed = 0;
    double part = 2.0; ///< of the step
  };
  enum class End : unsigned char
  {
    Crossing,
    Closed,
    Lost
  };
  /// +1 or -1: the sign of the direction that leads into the element; 0 where neither sign does.
  [[nodiscard]] int Inward(const ContourSeed& seed) const;
  [[nodiscard]] bool IsOn(std::size_t face, const ContourSeed& seed) const;
  /// Whether the curve is parallel to all faces that the point is on.
  [[nodiscard]] bool IsGrazing(const ContourSeed& seed) const;
  std::optional<Step> Try(const CurvePoint& from, double length, int sense);
  End Follow(
    std::vector<ContourSeed>& seeds, std::size_t first, int sense, std::vector<CurvePoint>& points);
  std::optional<Passed> FirstPassed(const std::vector<ContourSeed>& seeds, std::size_t first,
    bool mayClose, const CurvePoint& from, const Step& step, double after);
  std::optional<CurvePoint> Exit(const CurvePoint& from, const CurvePoint& to);

  CurveEvaluator& Evaluator;
  Shape shape_;
  TraceLimits Limits;
  std::vector<int> HeldFaces;
};
} // namespace pixelexact
