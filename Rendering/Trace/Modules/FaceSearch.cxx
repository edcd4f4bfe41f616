// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Modules/FaceSearch.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Faces/FacePlane.h"
#include "Trace/TileVisit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pixelexact
{
namespace
{
/// Largest count of steps, including bisections at the end of the surface.
constexpr int kMaxSteps = 8;
/// Largest last change, in pixels, of an unfinished search that still counts as found.
constexpr double kNearlySettled = 0.05;
constexpr int kNewtonSteps = 2;

/// The ray's hit that is nearest to a place.
std::optional<Vec3> NearestHit(const HitSlots& hits, int ray, const Vec3& place)
{
  std::optional<Vec3> nearest;
  double least = kNoHit;
  for (int k = 0; k < hits.Count() && hits.T(k)[ray] < kNoHit; ++k)
  {
    const Vec3 position = hits.PointOf(k, ray).position;
    const Vec3 off = position - place;
    const double distance = glm::dot(off, off);
    if (distance < least)
    {
      least = distance;
      nearest = position;
    }
  }
  return nearest;
}

using Open = std::vector<FaceSearch*>;

/// Meets the surface at the next places of one layer's searches.
void Meet(const Open& open, const TileVisit& tile, int layer, std::vector<HitSlots>& hits)
{
  std::vector<ImagePosition> positions;
  for (const FaceSearch* search : open)
  {
    positions.push_back(search->Place());
  }
  // The scene has no locator, so rays are not clipped to the mesh's box. Lines outside it are
  // found.
  Scene alone;
  alone.layers = { tile.GetScene().layers[static_cast<std::size_t>(layer)] };
  // All hits are needed: another sheet may be in front of the one with the line, and a surface may
  // omit hits after the nearest one.
  alone.layers.front().translucent = true;
  const CheckedOut<TileSamples> rays;
  (*rays).Begin(tile.GetCamera(), positions);
  (*rays).Meet(tile.GetCamera(), alone, hits);
}

/// The xi that map to `moved`, to first order, from the xi of the searches' pixels. Newton's steps
/// use the pixel's Jacobian; the less the map curves, the more digits each step adds.
std::vector<Vec3> Invert(const Open& open, const Mesh& mesh, std::span<const Vec3> moved)
{
  std::vector<Vec3> xi(open.size());
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    xi[i] = open[i]->xi + moved[i];
  }
  for (int step = 0; step < kNewtonSteps; ++step)
  {
    for (std::size_t begin = 0, end = 0; begin < open.size(); begin = end)
    {
      const int element = open[begin]->line.element;
      while (end < open.size() && open[end]->line.element == element)
      {
        ++end;
      }
      const MappedPoints mapped(mesh, element, std::span(xi).subspan(begin, end - begin), false);
      for (std::size_t i = begin; i < end; ++i)
      {
        const FaceSearch& search = *open[i];
        xi[i] += moved[i] - search.inverse * (mapped.At(i - begin) - search.mapped);
      }
    }
  }
  return xi;
}

/// Takes one step of a layer's open searches.
void StepOn(std::span<FaceSearch> searches, const TileVisit& tile, int layer, double reach)
{
  Open open;
  for (FaceSearch& search : searches)
  {
    if (search.open && search.layer == layer)
    {
      open.push_back(&search);
    }
  }
  if (open.empty())
  {
    return;
  }
  const CheckedOut<std::vector<HitSlots>> hits;
  Meet(open, tile, layer, *hits);
  const Mesh& mesh = tile.GetScene().locator->GetMesh();
  std::vector<Vec3> moved(open.size());
  std::vector<char> met(open.size());
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    const FaceSearch& search = *open[i];
    const auto place = NearestHit(
      (*hits).front(), static_cast<int>(i), search.position + search.tried * search.step);
    met[i] = place ? 1 : 0;
    if (place)
    {
      const double size = mesh.size[static_cast<std::size_t>(search.line.element)];
      moved[i] = search.inverse * ((*place - search.position) / size);
    }
  }
  const std::vector<Vec3> xi = Invert(open, mesh, moved);
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    FaceSearch& search = *open[i];
    if (met[i] == 0)
    {
      // The surface ends before the place; a line may be nearer.
      search.tried = 0.5 * (search.tried + search.reached);
      continue;
    }
    const auto faces = FacePlanesOf(mesh.ShapeOf(search.line.element));
    search.Advance(faces[static_cast<std::size_t>(search.line.face)].Distance(xi[i]), reach);
  }
}
} // namespace

void FaceSearch::Advance(double distance, double reach)
{
  const double moved = tried - reached;
  bool goes = std::isfinite(distance);
  if (std::fabs(moved) < kSettled)
  {
    root = tried;
  }
  else if (reached == 0.0)
  {
    // The parabola with the pixel's slope. After its first root the surface leaves the face again.
    const double bend = (distance - atPixel + slope * tried) / (tried * tried);
    const double under = slope * slope - 4.0 * bend * atPixel;
    goes = goes && under >= 0.0;
    root = 2.0 * atPixel / (slope + std::sqrt(std::max(under, 0.0)));
  }
  else
  {
    const double fall = (atReached - distance) / moved;
    goes = goes && fall > 0.0;
    root = tried + distance / fall;
  }
  reached = tried;
  atReached = distance;
  tried = root;
  found = goes && std::fabs(root - reached) <= kSettled;
  open = goes && !found && std::fabs(root) < 2.0 * kSlack * reach;
}

void Follow(std::span<FaceSearch> searches, const TileVisit& tile, double reach)
{
  const auto layers = static_cast<int>(tile.GetScene().layers.size());
  for (int step = 0; step < kMaxSteps; ++step)
  {
    for (int layer = 0; layer < layers; ++layer)
    {
      StepOn(searches, tile, layer, reach);
    }
  }
  for (FaceSearch& search : searches)
  {
    // An unfinished search may be close to the end of the surface.
    search.found =
      search.found || (search.open && std::fabs(search.root - search.reached) < kNearlySettled);
    search.line.distance = search.root;
  }
}
} // namespace pixelexact
