// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/LayerSight.h"

#include "Core/Shape/Shape.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
/// Largest ratio of the distance of two near hits to the distance of their rays.
constexpr double kSteepest = 64.0;
/// Factor on the mesh's depth that covers rounding.
constexpr double kBeyond = 1.0 + 1e-6;
} // namespace

LayerSight::LayerSight(TileVisit& tile, int layer, const LayerBounds& bounds)
  : Tile(tile)
  , Layer(layer)
  , Bounds(bounds)
  , surface_(*tile.GetScene().layers[static_cast<std::size_t>(layer)].surface)
  , plane_(dynamic_cast<const Plane*>(&surface_))
{
  const CameraRays& rays = Tile.GetCamera().Rays();
  IsParallel = rays.direction.u == Vec3(0.0) && rays.direction.v == Vec3(0.0);
  if (IsParallel || !plane_)
  {
    return;
  }
  const Box3 box = Tile.GetScene().locator->Index().Bounds();
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 x((corner & 1) != 0 ? box.upper.x : box.lower.x,
      (corner & 2) != 0 ? box.upper.y : box.lower.y, (corner & 4) != 0 ? box.upper.z : box.lower.z);
    MeshDepth = std::max(MeshDepth, kBeyond * DepthOf(x));
  }
}

double LayerSight::DepthOf(const Vec3& x) const
{
  const auto& [origin, direction] = Tile.GetCamera().Rays();
  const Vec3 across = glm::cross(direction.u, direction.v);
  return glm::dot(x - origin.constant, across) / glm::dot(direction.constant, across);
}

bool LayerSight::IsPlaneBeyond(std::span<const EdgeEnd> ends) const
{
  if (!plane_ || std::ranges::all_of(ends, &EdgeEnd::isAhead))
  {
    return false;
  }
  // A plane's reciprocal depth (with parallel rays: its depth) is linear in the image. So if no
  // end's ray meets the plane, no ray between them does, and no hit is nearer than the nearest
  // end's.
  return std::ranges::none_of(ends,
    [this](const EdgeEnd& end)
    { return end.isAhead && (IsParallel || DepthOf(end.point.x) <= MeshDepth); });
}

Ray LayerSight::RayOf(const EdgeEnd& end) const
{
  return Tile.GetCamera().At(end.position[0], end.position[1]);
}

EdgeEnd LayerSight::EndOf(
  const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const
{
  EdgeEnd end;
  end.position = position;
  end.isUnknown = samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Unknown);
  if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
  {
    end.layer = samples.layer[i];
  }
  if (Shows(end))
  {
    end.element = static_cast<int>(samples.element[i]);
    end.point.x = samples.position[i];
    end.point.xi = samples.xi[i];
    end.point.value = ValueAt(samples, i);
    if (!samples.piece.empty())
    {
      end.piece = samples.piece[i];
      end.parameters[0] = samples.pieceU[i];
      end.parameters[1] = samples.pieceV[i];
      end.face = surface_.FaceOf(end.piece);
    }
    end.point.eta =
      ReferenceToTensor(Tile.GetScene().locator->GetMesh().ShapeOf(end.element), end.point.xi);
    end.meets = true;
    end.isAhead = true;
  }
  else if (plane_)
  {
    MeetPlane(end);
  }
  return end;
}

void LayerSight::MeetPlane(EdgeEnd& end) const
{
  // The plane continues outside the mesh and, with parallel rays, behind the eye.
  const auto [t, x] = plane_->Cross(RayOf(end));
  end.isAhead = kNearest <= t && t <= kFarthest;
  end.meets = end.isAhead || (IsParallel && kNearest <= -t && -t <= kFarthest);
  end.point.x = end.meets ? x : Vec3(0.0);
}

std::vector<EdgeEnd> LayerSight::Trace(std::span<const ImagePosition> positions)
{
  const SampleBuffers samples = Tile.Trace(positions, kEdgeSampleBuffers | Buffer::Piece);
  std::vector<EdgeEnd> ends;
  ends.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    ends.push_back(EndOf(samples, i, positions[i]));
  }
  return ends;
}

SurfaceEdge LayerSight::EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const
{
  SurfaceEdge edge{ a.point.x, b.point.x, std::numeric_limits<double>::infinity() };
  if (a.meets && b.meets)
  {
    edge.sagitta =
      plane_ ? 0.0 : surface_.Sagitta(RayOf(a), a.OnSurface(), RayOf(b), b.OnSurface());
  }
  return edge;
}

double LayerSight::SagittaOver(const std::array<const EdgeEnd*, 3>& ends) const
{
  std::array<Ray, 3> rays;
  std::array<Vec3, 3> hits;
  for (std::size_t k = 0; k < ends.size(); ++k)
  {
    if (!ends[k]->meets)
    {
      return std::numeric_limits<double>::infinity();
    }
    rays[k] = RayOf(*ends[k]);
    hits[k] = ends[k]->point.x;
  }
  return surface_.SagittaOver(rays, hits);
}

bool LayerSight::AreNear(const EdgeEnd& a, const EdgeEnd& b) const
{
  if (plane_)
  {
    return true;
  }
  const Ray first = RayOf(a);
  const Ray second = RayOf(b);
  const double depth = glm::distance(first.origin, a.point.x);
  const double apart = glm::distance(a.point.x, second.origin + depth * second.direction);
  return glm::distance(a.point.x, b.point.x) <= kSteepest * apart;
}
} // namespace pixelexact
