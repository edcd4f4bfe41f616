// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/LayerSight.h"

#include "Core/Shape/Shape.h"
#include "Trace/Contours/EdgeSample.h"

#include <glm/geometric.hpp>

#include <limits>

namespace pixelexact
{
namespace
{
/// Distance of two hits over that of their rays, up to which they count as near.
constexpr double kSteepest = 64.0;
} // namespace

LayerSight::LayerSight(TileVisit& tile, int layer)
  : Tile(tile)
  , Layer(layer)
  , TheSurface(*tile.GetScene().layers[static_cast<std::size_t>(layer)].surface)
{
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
  if (samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact))
  {
    end.layer = samples.layer[i];
  }
  if (Shows(end))
  {
    end.element = static_cast<int>(samples.element[i]);
    end.point.x = samples.position[i];
    end.point.xi = samples.xi[i];
    end.point.value = samples.value[i];
    if (!samples.piece.empty())
    {
      end.piece = samples.piece[i];
      end.parameters[0] = samples.pieceU[i];
      end.parameters[1] = samples.pieceV[i];
    }
    end.point.eta =
      ReferenceToTensor(Tile.GetScene().locator->GetMesh().ShapeOf(end.element), end.point.xi);
    end.meets = true;
  }
  else if (TheSurface.IsPlane())
  {
    // A plane goes on where the mesh ends.
    const std::vector<Hit> hits = HitsOf(TheSurface, RayOf(end));
    end.meets = !hits.empty();
    end.point.x = end.meets ? hits.front().position : Vec3(0.0);
  }
  return end;
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
    edge.sagitta = TheSurface.IsPlane()
      ? 0.0
      : TheSurface.Sagitta(RayOf(a), a.OnSurface(), RayOf(b), b.OnSurface());
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
  return TheSurface.SagittaOver(rays, hits);
}

bool LayerSight::AreNear(const EdgeEnd& a, const EdgeEnd& b) const
{
  if (TheSurface.IsPlane())
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
