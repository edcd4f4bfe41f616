// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/ConvexBody.h"

#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/PairArithmetic.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace pixelexact
{
namespace
{
/// The face in the world of a half-space on the other side of the map.
ConvexFace Moved(const HalfSpace& face, const AffineMap& map, const char* what)
{
  Vec3 point = map.Preimage(face.point, what);
  // The preimage is rounded; how far off it is is not.
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
} // namespace pixelexact
