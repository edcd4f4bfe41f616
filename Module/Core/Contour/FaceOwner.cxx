// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/FaceOwner.h"

#include "Core/Faces/FacePlane.h"
#include "Core/Faces/ReferenceFace.h"
#include "Core/Location/Sample.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr double kHolderOnFace = 1e-6;
/// One of two faces is smaller if its area is below this fraction of that of the other.
constexpr double kSmaller = 0.75;

class Holders final : public PreimageSink
{
public:
  void Found(int /*index*/, const Preimage& preimage) override { All.push_back(preimage); }
  void Undecided(int /*index*/, int /*element*/) override {}

  std::vector<Preimage> All;
};
} // namespace

double FaceOwner::AreaOf(int element, int face) const
{
  const Mesh& mesh = locator_.GetMesh();
  const ReferenceFace& reference = ReferenceFaceOf(mesh.ShapeOf(element), face);
  const auto corners = static_cast<std::size_t>(reference.corners);
  std::vector<Vec3> x(corners);
  MapForward(mesh, element, std::span(reference.corner).first(corners), x);
  // Half the product of a quadrilateral's diagonals, of a triangle's sides.
  return corners == 4 ? glm::length(glm::cross(x[2] - x[0], x[3] - x[1])) / 2.0
                      : glm::length(glm::cross(x[1] - x[0], x[2] - x[0])) / 2.0;
}

ElementFace FaceOwner::SmallestOther(int element, const Vec3& x) const
{
  Holders holders;
  locator_.LocateAll(std::span(&x, 1), holders);
  ElementFace smallest;
  double least = 0.0;
  for (const Preimage& holder : holders.All)
  {
    const auto planes = FacePlanesOf(locator_.GetMesh().ShapeOf(holder.element));
    for (std::size_t k = 0; holder.element != element && k < planes.size(); ++k)
    {
      const auto face = static_cast<int>(k);
      const double area = AreaOf(holder.element, face);
      if (std::fabs(planes[k].Distance(holder.xi)) <= kHolderOnFace &&
        (smallest.element < 0 || area < least))
      {
        smallest = { holder.element, face };
        least = area;
      }
    }
  }
  return smallest;
}

bool FaceOwner::IsAnothers(int element, int face, const CurvePoint& point) const
{
  const FaceKind kind = Faces.KindOf(element, face);
  if (kind == FaceKind::Boundary)
  {
    return false;
  }
  const ElementFace neighbour =
    kind == FaceKind::Interior ? Faces.NeighbourOf(element, face) : SmallestOther(element, point.x);
  if (neighbour.element < 0)
  {
    return false;
  }
  const double own = AreaOf(element, face);
  const double others = AreaOf(neighbour.element, neighbour.face);
  const bool isLike =
    kind == FaceKind::Interior || (others > kSmaller * own && own > kSmaller * others);
  return isLike ? neighbour.element < element : others < own;
}
} // namespace pixelexact
