// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/ConvexBody.h"

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/PairArithmetic.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The face in the world of a half-space that is given in the function's space.
ConvexFace Moved(const HalfSpace& face, const AffineMap& map, const char* what)
{
  Vec3 point = map.Preimage(face.point, what);
  // The preimage is rounded; its height over the face is computed in pairs.
  DoublePair height;
  for (int i = 0; i < 3; ++i)
  {
    DoublePair off = ExactSum(map.offset[i], -face.point[i]);
    for (int j = 0; j < 3; ++j)
    {
      off = off + ExactProduct(map.linear[j][i], point[j]);
    }
    height = height + face.normal[i] * off;
  }
  const Vec3 gradient = glm::transpose(map.linear) * face.normal;
  const double size = LargestOf(gradient);
  const Vec3 across = gradient / size;
  point -= across * (height.high / size / glm::dot(across, across));
  return { point, UnitDirection(across) };
}
} // namespace

ConvexBody::ConvexBody(
  const std::vector<HalfSpace>& halfSpaces, const AffineMap& toFunction, const char* what)
{
  if (halfSpaces.empty())
  {
    Refuse(what, "there is no half-space; give at least one.");
  }
  for (const HalfSpace& given : halfSpaces)
  {
    CheckPosition(given.point, what);
    const HalfSpace scaled{ given.point, ScaledDirection(given.normal, what, "normal") };
    Faces.push_back(toFunction.IsIdentity()
        ? ConvexFace{ scaled.point, UnitDirection(scaled.normal) }
        : Moved(scaled, toFunction, what));
  }
}

void ConvexBody::Meet(const RayLanes& rays, HitSlots& hits) const
{
  GetConvexKernels().meet(Faces.data(), static_cast<int>(Faces.size()), rays, hits);
}

double ConvexBody::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  const Chord chord{ a, atA.position, b, atB.position };
  if (atA.piece >= 0 && atA.piece == atB.piece)
  {
    // A face is convex, so the chord lies in it.
    const ConvexFace& face = Faces[static_cast<std::size_t>(atA.piece)];
    return ReachOfPlane(chord, face.point, face.normal);
  }
  return ReachWithRoom(chord, [this](const Chord& wider) { return Reach(wider); });
}

double ConvexBody::Reach(const Chord& chord) const
{
  // The boundary is the zero set of g, the largest of the faces' heights: a convex function with
  // Lipschitz constant 1. On the chord it is at most the larger of its ends' values. It is at least
  // the heights over the planes of the faces a and b that are largest at the ends,
  //   g_a + s n_a.e  and  g_b - (1 - s) n_b.e,  where e leads from end to end.
  // The larger of these is below both g_a and g_b by at most alpha beta / (alpha + beta), where
  // alpha and beta are the planes' falls towards the other end.
  const Vec3 e = chord.Along();
  const Vec3 middle = chord.Middle();
  const double radius = chord.Radius();
  double size = 0.0;
  double atA = -kNoHit;
  double atB = -kNoHit;
  double atMiddle = -kNoHit;
  double alpha = 0.0;
  double beta = 0.0;
  for (const ConvexFace& face : Faces)
  {
    const auto height = [&](const Vec3& x) { return glm::dot(face.normal, x - face.point); };
    if (const double h = height(chord.from); h > atA)
    {
      atA = h;
      alpha = std::max(0.0, -glm::dot(face.normal, e));
    }
    if (const double h = height(chord.to); h > atB)
    {
      atB = h;
      beta = std::max(0.0, glm::dot(face.normal, e));
    }
    atMiddle = std::max(atMiddle, height(middle));
    size = std::max(size, glm::length(face.point));
  }
  const double rounding = chord.Slack() + 16.0 * kUnitRoundoff * size;
  const double fall = alpha + beta > 0.0 ? alpha * beta / (alpha + beta) : 0.0;
  const double value = std::max(std::fabs(atA), std::fabs(atB)) + fall + 2.0 * rounding;
  // In the ball about the middle, g's slope is that of a face whose height there may be the
  // largest.
  double least = kNoHit;
  double most = -kNoHit;
  for (const ConvexFace& face : Faces)
  {
    if (glm::dot(face.normal, middle - face.point) >= atMiddle - 2.0 * (radius + rounding))
    {
      const double slope = glm::dot(face.normal, chord.a.direction);
      least = std::min(least, slope);
      most = std::max(most, slope);
    }
  }
  const double slope = least > 0.0 ? least : std::min(most, 0.0);
  return ReachBySlope(chord, value, slope, chord.Turn() + 16.0 * kUnitRoundoff);
}

bool ConvexBody::IsClearOf(const Vec3& centre, double radius) const
{
  double largest = -kNoHit;
  double size = glm::length(centre) + radius;
  for (const ConvexFace& face : Faces)
  {
    largest = std::max(largest, glm::dot(face.normal, centre - face.point));
    size = std::max(size, glm::length(face.point));
  }
  return std::fabs(largest) > radius + 32.0 * kUnitRoundoff * size;
}

Vec3 ConvexBody::Normal(const SurfacePoint& point) const
{
  if (point.piece >= 0)
  {
    return Faces[static_cast<std::size_t>(point.piece)].normal;
  }
  const ConvexFace* closest = Faces.data();
  double least = kNoHit;
  for (const ConvexFace& face : Faces)
  {
    const double distance = std::fabs(glm::dot(face.normal, point.position - face.point));
    if (distance < least)
    {
      least = distance;
      closest = &face;
    }
  }
  return closest->normal;
}

ConvexBody MakeBox(const Vec3& lower, const Vec3& upper, const AffineMap& toFunction)
{
  CheckPosition(lower, "box");
  CheckPosition(upper, "box");
  std::vector<HalfSpace> sides;
  for (int d = 0; d < 3; ++d)
  {
    if (lower[d] > upper[d])
    {
      Refuse("box", "a lower coordinate is above the upper one; give them in order.");
    }
    Vec3 normal(0.0);
    normal[d] = 1.0;
    sides.push_back({ lower, -normal });
    sides.push_back({ upper, normal });
  }
  return ConvexBody(sides, toFunction, "box");
}

std::vector<SurfacePatch> ConvexBody::Implicit() const
{
  std::vector<ImplicitPolynomial> planes;
  for (const ConvexFace& face : Faces)
  {
    planes.push_back(ImplicitPolynomial::Plane(face.point, face.normal));
  }
  return FacesOfBody(planes);
}
} // namespace pixelexact
