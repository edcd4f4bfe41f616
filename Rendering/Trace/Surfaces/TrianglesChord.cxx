// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the distance of triangles from chords.
#include "Trace/Surfaces/Triangles.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/RayPlane.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pixelexact
{
namespace
{
/// Largest count of triangles between two hits; longer chords are subdivided.
constexpr int kMaxTriangles = 32;

/// The intersection of an edge with the rays' plane.
struct EdgeCrossing
{
  Vec3 p;
  Vec3 q;
  Vec3 at;
  double error; ///< of `at`, along the edge
};

/// The exit from a triangle that leads farthest towards the chord's end, among edges that are
/// proven to cross the plane; none if a corner may lie in the plane.
std::optional<EdgeCrossing> WayOut(
  const RayPlane& plane, const Triangles::Triangle& triangle, const Vec3& from)
{
  double height[3];
  double uncertainty[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    height[k] = plane.Height(triangle[k]);
    uncertainty[k] = plane.Uncertainty(triangle[k]);
    if (!(std::fabs(height[k]) > uncertainty[k]))
    {
      return std::nullopt;
    }
  }
  std::optional<EdgeCrossing> best;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    if ((height[k] > 0.0) == (height[next] > 0.0))
    {
      continue;
    }
    const Vec3& p = triangle[k];
    const Vec3& q = triangle[next];
    const double fall = std::fabs(height[k]) + std::fabs(height[next]);
    const Vec3 at = p + std::fabs(height[k]) / fall * (q - p);
    if (!best || plane.Progress(from, at) > plane.Progress(from, best->at))
    {
      best = { p, q, at, (uncertainty[k] + uncertainty[next]) / fall * glm::distance(p, q) };
    }
  }
  return best;
}

bool HasCorner(const Triangles::Triangle& triangle, const Vec3& x)
{
  return triangle[0] == x || triangle[1] == x || triangle[2] == x;
}
} // namespace

std::int32_t Triangles::Beyond(
  std::int32_t triangle, const Vec3& p, const Vec3& q, std::int32_t wanted) const
{
  const CheckedOut<std::vector<int>> near;
  ForRays().Query({ p, p }, *near);
  std::int32_t found = -1;
  int count = 0;
  for (const int k : *near)
  {
    const Triangle& other = All[static_cast<std::size_t>(k)];
    if (k != triangle && HasCorner(other, p) && HasCorner(other, q))
    {
      ++count;
      found = found == wanted ? found : k;
    }
  }
  return count == 1 || found == wanted ? found : -1;
}

double Triangles::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  const Chord chord{ a, atA.position, b, atB.position };
  const RayPlane plane(chord);
  if (!plane.IsKnown() || atA.piece < 0 || atB.piece < 0)
  {
    return kInfinity;
  }
  // The rays' plane cuts triangles with shared edges in a polyline. If each segment leads forward
  // across the rays, each ray between meets the polyline once. The polyline's distance from the
  // chord is at most that of its corners.
  std::int32_t piece = atA.piece;
  Vec3 at = chord.from;
  double reach = plane.OffChord(chord.from);
  double error = 0.0;
  for (int crossed = 0; piece != atB.piece; ++crossed)
  {
    const auto out = WayOut(plane, All[static_cast<std::size_t>(piece)], at);
    if (!out || crossed == kMaxTriangles)
    {
      return kInfinity;
    }
    error += out->error;
    piece = plane.Progress(at, out->at) >= -(error + chord.Slack())
      ? Beyond(piece, out->p, out->q, atB.piece)
      : -1;
    if (piece < 0)
    {
      return kInfinity;
    }
    at = out->at;
    reach = std::max(reach, plane.OffChord(at) + out->error);
  }
  // Positions are projected to planes whose normals are inaccurate for slender triangles.
  return plane.Progress(at, chord.to) >= -(error + chord.Slack())
    ? reach + SlackOf(atA.piece) + SlackOf(atB.piece)
    : kInfinity;
}

double Triangles::SlackOf(std::int32_t triangle) const
{
  const auto& [a, b, c] = All[static_cast<std::size_t>(triangle)];
  const double longest =
    std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
  return 16.0 * kUnitRoundoff * longest * longest * longest / glm::length(glm::cross(b - a, c - a));
}
} // namespace pixelexact
