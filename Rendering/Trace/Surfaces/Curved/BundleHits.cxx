// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/BundleHits.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace pixelexact
{
namespace
{
/// Largest distance of equal hits, relative to an element's size.
constexpr double kSame = 1e-11;

/// Order of the hits of one ray: by t, then by part.
bool ComesBefore(const CurvedHit& a, const CurvedHit& b)
{
  return a.t != b.t ? a.t < b.t : a.part < b.part;
}

/// Writes hits of some rays of a tile to one slot.
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
  std::array<const CurvedHit*, RayBundle::kMax> nearest{};
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

/// A bundle's hits, ray by ray.
class HitsByRay
{
public:
  explicit HitsByRay(std::span<const CurvedHit> found)
    : Sorted(found.size())
  {
    for (const CurvedHit& hit : found)
    {
      ++Ends[static_cast<std::size_t>(hit.ray) + 1];
    }
    std::partial_sum(Ends.begin(), Ends.end(), Ends.begin());
    std::array<std::size_t, RayBundle::kMax + 1> next = Ends;
    for (const CurvedHit& hit : found)
    {
      Sorted[next[static_cast<std::size_t>(hit.ray)]++] = &hit;
    }
  }
  /// The hits of one ray, in order.
  [[nodiscard]] std::span<const CurvedHit* const> Of(std::size_t ray)
  {
    const auto some = std::span(Sorted).subspan(Ends[ray], Ends[ray + 1] - Ends[ray]);
    if (some.size() > 1)
    {
      std::ranges::stable_sort(
        some, [](const CurvedHit* a, const CurvedHit* b) { return ComesBefore(*a, *b); });
    }
    return some;
  }

private:
  std::vector<const CurvedHit*> Sorted;
  std::array<std::size_t, RayBundle::kMax + 1> Ends{}; ///< end of each ray's hits, from index 1 on
};

void WriteAll(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::span<const CurvedHit> found, HitSlots& hits)
{
  if (found.empty())
  {
    return;
  }
  HitsByRay byRay(found);
  std::optional<SlotWriter> nearest;   // most rays have no other slot
  std::vector<std::int32_t> undecided; // parts with an undecided hit since the last certain one
  for (int ray = 0; ray < count; ++ray)
  {
    int slot = 0;
    const CurvedHit* last = nullptr;
    undecided.clear();
    for (const CurvedHit* hit : byRay.Of(static_cast<std::size_t>(ray)))
    {
      const auto element =
        static_cast<std::size_t>(terms.parts[static_cast<std::size_t>(hit->part)].element);
      const double same = kSame * terms.mesh.size[element];
      // Consecutive undecided hits of one part are written once.
      const bool isUndecided = hit->status == HitStatus::Undecided;
      const bool isWritten =
        isUndecided && std::ranges::find(undecided, hit->part) != undecided.end();
      if (!IsWithin(rays, first + ray, *hit) || isWritten ||
        (last != nullptr &&
          glm::all(glm::lessThanEqual(glm::abs(hit->position - last->position), Vec3(same)))))
      {
        continue;
      }
      if (slot > 0)
      {
        SlotWriter(terms, hits, slot).Write(first + ray, *hit);
      }
      else
      {
        if (!nearest)
        {
          nearest.emplace(terms, hits, 0);
        }
        nearest->Write(first + ray, *hit);
      }
      if (isUndecided)
      {
        undecided.push_back(hit->part);
      }
      else
      {
        undecided.clear();
      }
      last = hit;
      ++slot;
    }
  }
}
} // namespace

void WriteHits(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::span<const CurvedHit> found, HitSlots& hits)
{
  if (rays.nearestOnly)
  {
    WriteFirst(rays, first, count, terms, found, hits);
  }
  else
  {
    WriteAll(rays, first, count, terms, found, hits);
  }
}
} // namespace pixelexact
