// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/RayPlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
RayPlane::RayPlane(const Chord& chord)
  : Start(chord.from)
  , Length(chord.Length())
  , Slack(chord.Slack())
{
  const Vec3 e = chord.Along() / Length;
  const Vec3 normal = glm::cross(e, 0.5 * (chord.a.direction + chord.b.direction));
  const double size = glm::length(normal);
  Normal = normal / size;
  Across = glm::cross(Normal, e);
  // Directions between the two are positive combinations of them, and so are the vectors
  // perpendicular to them. A sign that holds for both therefore holds for all. The sine of the
  // angle to the chord is least at one of the two.
  LeastSine = 1.0;
  Known = true;
  const Vec3 directions[2] = { chord.a.direction, chord.b.direction };
  for (int k = 0; k < 2; ++k)
  {
    Forward[k] = glm::cross(directions[k], Normal);
    const double sine = glm::dot(Forward[k], e);
    // The comparison makes a NaN unknown.
    Known = Known && sine > 0.0 && sine * Length > 4.0 * Slack;
    LeastSine = std::min(LeastSine, sine);
  }
}

double RayPlane::Height(const Vec3& x) const
{
  return glm::dot(Normal, x - Start);
}

double RayPlane::Uncertainty(const Vec3& x) const
{
  // The errors of the chord's ends may rotate the chord.
  return 2.0 * Slack * (1.0 + glm::distance(x, Start) / (LeastSine * Length));
}

double RayPlane::Progress(const Vec3& from, const Vec3& to) const
{
  return std::min(glm::dot(Forward[0], to - from), glm::dot(Forward[1], to - from));
}

double RayPlane::OffChord(const Vec3& x) const
{
  return (std::fabs(glm::dot(Across, x - Start)) + Slack) / LeastSine;
}
} // namespace pixelexact
