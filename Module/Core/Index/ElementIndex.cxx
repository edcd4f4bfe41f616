// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Index/ElementIndex.h"

#include "Core/Base/Error.h"
#include "Core/Base/StageClock.h"
#include "Core/Math/Interval.h"
#include "Core/Math/Rounding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pixelexact
{
namespace
{
constexpr int kMostPieces = 64;

Box3 EmptyBox()
{
  return { Vec3(kInfinity), Vec3(-kInfinity) };
}

bool IsFinite(const Vec3& x)
{
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}
} // namespace

ElementIndex::ElementIndex(const Mesh& mesh)
  : TheMesh(mesh)
  , Boxes(static_cast<std::size_t>(mesh.Elements()))
  , Made(new std::atomic<const ElementBounds*>[static_cast<std::size_t>(mesh.Elements())]())
{
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e) { Boxes[static_cast<std::size_t>(e)] = MakeElementBox(TheMesh, e); });
  MeshBounds = EmptyBox();
  for (const Box3& box : Boxes)
  {
    MeshBounds.lower = glm::min(MeshBounds.lower, box.lower);
    MeshBounds.upper = glm::max(MeshBounds.upper, box.upper);
  }
  if (!Boxes.empty())
  {
    Hierarchy = std::make_unique<Bvh>(Boxes, MeshBounds);
  }
}

ElementIndex::~ElementIndex()
{
  for (std::size_t e = 0; e < Boxes.size(); ++e)
  {
    delete Made[e].load();
  }
}

/// Numbers come in ascending order.
void ElementIndex::SortByPriority(std::vector<int>& elements) const
{
  if (!Priority.empty())
  {
    std::ranges::stable_sort(
      elements, {}, [this](int element) { return Priority[static_cast<std::size_t>(element)]; });
  }
}

void ElementIndex::SetPriority(std::span<const std::int64_t> priority)
{
  if (!priority.empty() && priority.size() != Boxes.size())
  {
    throw Error("owners' priorities need one entry for each of the " +
      std::to_string(Boxes.size()) + " elements.");
  }
  Priority.assign(priority.begin(), priority.end());
}

void ElementIndex::FindNear(const Box3& region, std::vector<int>& elements) const
{
  elements.clear();
  if (Hierarchy)
  {
    Hierarchy->Query(region, elements);
    SortByPriority(elements);
  }
}

void ElementIndex::FindAlong(std::span<const Segment> segments, std::vector<int>& elements) const
{
  elements.clear();
  if (!Hierarchy)
  {
    return;
  }
  // A box about a whole slanted segment meets far more elements than the segment: so pieces of it,
  // about as many as there are elements along it.
  const int pieces =
    std::clamp(static_cast<int>(std::cbrt(static_cast<double>(Boxes.size()))), 1, kMostPieces);
  std::vector<int> near;
  for (int piece = 0; piece < pieces; ++piece)
  {
    Box3 region = EmptyBox();
    for (const Segment& segment : segments)
    {
      if (!IsFinite(segment.from) || !IsFinite(segment.to))
      {
        continue;
      }
      for (const int end : { piece, piece + 1 })
      {
        const double part = static_cast<double>(end) / pieces;
        const Vec3 at = segment.from * (1.0 - part) + segment.to * part;
        const Vec3 rounding = Vec3(segment.slack) +
          8.0 * kUnitRoundoff * glm::max(glm::abs(segment.from), glm::abs(segment.to));
        region.lower = glm::min(region.lower, at - rounding);
        region.upper = glm::max(region.upper, at + rounding);
      }
    }
    if (region.lower.x <= region.upper.x)
    {
      Hierarchy->Query(region, near);
      elements.insert(elements.end(), near.begin(), near.end());
    }
  }
  std::ranges::sort(elements);
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  SortByPriority(elements);
}

std::optional<Segment> ElementIndex::ClipRay(
  const Vec3& origin, const Vec3& direction, double tNear, double tFar) const
{
  return pixelexact::ClipRay(MeshBounds, origin, direction, tNear, tFar);
}

const ElementBounds& ElementIndex::MakeBounds(int element) const
{
  const StageScope scope(Stage::Bounds);
  auto mine = std::make_unique<const ElementBounds>(MakeElementBounds(TheMesh, element));
  const ElementBounds* before = nullptr;
  // Two threads may make the same bounds; they are equal, and the first stay.
  if (!Made[static_cast<std::size_t>(element)].compare_exchange_strong(
        before, mine.get(), std::memory_order_acq_rel))
  {
    return *before;
  }
  ++MadeCount;
  return *mine.release();
}

std::shared_ptr<ElementTree> ElementIndex::TreeOf(int element) const
{
  const ElementBounds& bounds = BoundsOf(element);
  std::vector<std::shared_ptr<ElementTree>> dropped; // destroyed without the lock
  const std::scoped_lock lock(TreesMutex);
  if (Grown.load(std::memory_order_relaxed) > TreeLimit.load(std::memory_order_relaxed))
  {
    dropped.swap(Trees);
  }
  Trees.resize(Boxes.size());
  auto& tree = Trees[static_cast<std::size_t>(element)];
  if (!tree)
  {
    tree = std::make_shared<ElementTree>(TheMesh, element, bounds, Grown);
  }
  return tree;
}

std::size_t ElementIndex::TreeBytes() const
{
  return static_cast<std::size_t>(std::max(std::int64_t{ 0 }, Grown.load()));
}

std::size_t ElementIndex::MemoryUsage() const
{
  return Boxes.capacity() * sizeof(Box3) + Boxes.size() * sizeof(void*) +
    static_cast<std::size_t>(MadeCount.load()) * sizeof(ElementBounds) +
    (Hierarchy ? Hierarchy->MemoryUsage() : 0) + TreeBytes();
}
} // namespace pixelexact
