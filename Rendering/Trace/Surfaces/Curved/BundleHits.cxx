// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/BundleHits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Of an element's size.
constexpr double kSame = 1e-11;

/// Hits of one ray: by t, then by part.
bool ComesBefore(const CurvedHit& a, const CurvedHit& b)
{
  return a.t != b.t ? a.t < b.t : a.part < b.part;
}

/// A slot, as it is written for some rays of a tile.
class SlotWriter
{
public:
  SlotWriter(const HitTerms& terms, HitSlots& hits, int slot)
    : Terms(terms)
    , Hits(hits)
    , Slot(slot)
    , Lanes(hits.Slot(slot))
    , Pieces(hits.Pieces(slot))
    , Elements(terms.tellsElements ? hits.Elements(slot) : ElementLanes{})
  {
  }

  void Write(int ray, const CurvedHit& hit) const
  {
    Lanes.t[ray] = hit.t;
    for (int d = 0; d < 3; ++d)
    {
      Lanes.position[d][ray] = hit.position[d];
    }
    if (hit.status != HitStatus::Certain)
    {
      Hits.Status(Slot)[ray] = hit.status;
    }
    Pieces.piece[ray] = hit.part;
    if (!Terms.tellsElements)
    {
      Pieces.parameters[0][ray] = hit.xi.x;
      Pieces.parameters[1][ray] = hit.xi.y;
      return;
    }
    Elements.element[ray] = Terms.parts[static_cast<std::size_t>(hit.part)].element;
    for (int d = 0; d < 3; ++d)
    {
      Elements.xi[d][ray] = hit.xi[d];
    }
  }

private:
  const HitTerms& Terms;
  HitSlots& Hits;
  int Slot;
  HitLanes Lanes;
  PieceLanes Pieces;
  ElementLanes Elements;
};

bool IsWithin(const RayLanes& rays, int ray, const CurvedHit& hit)
{
  return hit.t >= rays.tNear[ray] && hit.t <= rays.tFar[ray];
}

void WriteFirst(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::span<const CurvedHit> found, HitSlots& hits)
{
  std::array<const CurvedHit*, RayBundle::kMost> nearest{};
  for (const CurvedHit& hit : found)
  {
    const CurvedHit*& best = nearest[static_cast<std::size_t>(hit.ray)];
    if (IsWithin(rays, first + hit.ray, hit) && (best == nullptr || ComesBefore(hit, *best)))
    {
      best = &hit;
    }
  }
  const auto end = nearest.begin() + count;
  if (std::none_of(nearest.begin(), end, [](const CurvedHit* hit) { return hit != nullptr; }))
  {
    return;
  }
  const SlotWriter writer(terms, hits, 0);
  for (auto at = nearest.begin(); at != end; ++at)
  {
    if (*at != nullptr)
    {
      writer.Write(first + (*at)->ray, **at);
    }
  }
}

void WriteAll(const RayLanes& rays, int first, const HitTerms& terms, std::vector<CurvedHit>& found,
  HitSlots& hits)
{
  std::ranges::stable_sort(found,
    [](const CurvedHit& a, const CurvedHit& b)
    { return a.ray != b.ray ? a.ray < b.ray : ComesBefore(a, b); });
  int slot = 0;
  std::size_t last = 0;
  std::vector<std::int32_t> told; // parts, since the last hit that is certain
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const CurvedHit& hit = found[k];
    if (k == 0 || found[k - 1].ray != hit.ray)
    {
      slot = 0;
      told.clear();
    }
    const auto element =
      static_cast<std::size_t>(terms.parts[static_cast<std::size_t>(hit.part)].element);
    const double same = kSame * terms.mesh.size[element];
    // What is undecided in one part, piece by piece along the ray, is told once.
    const bool isUndecided = hit.status == HitStatus::Undecided;
    const bool isTold = isUndecided && std::ranges::find(told, hit.part) != told.end();
    if (!IsWithin(rays, first + hit.ray, hit) || isTold ||
      (slot > 0 &&
        glm::all(glm::lessThanEqual(glm::abs(hit.position - found[last].position), Vec3(same)))))
    {
      continue;
    }
    SlotWriter(terms, hits, slot).Write(first + hit.ray, hit);
    if (isUndecided)
    {
      told.push_back(hit.part);
    }
    else
    {
      told.clear();
    }
    last = k;
    ++slot;
  }
}
} // namespace

void WriteHits(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::vector<CurvedHit>& found, HitSlots& hits)
{
  if (rays.nearestOnly)
  {
    WriteFirst(rays, first, count, terms, found, hits);
  }
  else
  {
    WriteAll(rays, first, terms, found, hits);
  }
}
} // namespace pixelexact
