// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Chord.h"

#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
double Chord::Length() const
{
  return glm::distance(from, to);
}

double Chord::Turn() const
{
  return glm::distance(a.direction, b.direction);
}

double Chord::Slack() const
{
  // A direction's error is some roundings. At the hit it is multiplied by the distance from the
  // origin.
  return 16.0 * kUnitRoundoff *
    (glm::length(a.origin) + glm::length(b.origin) + glm::length(from) + glm::length(to));
}

double ReachBySlope(const Chord& chord, double value, double slope, double change)
{
  const double reach = value / (std::fabs(slope) - change) * (1.0 + 1e-9);
  // The comparison makes a NaN infinite.
  return std::fabs(slope) > change && reach <= chord.Room()
    ? reach
    : std::numeric_limits<double>::infinity();
}

double ReachOfPlane(const Chord& chord, const Vec3& point, const Vec3& unitNormal)
{
  const double rounding = chord.Slack() + 16.0 * kUnitRoundoff * glm::length(point);
  const double value = std::max(std::fabs(glm::dot(unitNormal, chord.from - point)),
    std::fabs(glm::dot(unitNormal, chord.to - point)));
  return ReachBySlope(chord, value + rounding, glm::dot(unitNormal, chord.a.direction),
    chord.Turn() + 16.0 * kUnitRoundoff);
}
} // namespace pixelexact
