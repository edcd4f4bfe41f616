// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Index/ElementIndex.h"

#include "Core/Base/StageClock.h"
#include "Core/Math/Interval.h"

#include <glm/common.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace pixelexact
{
namespace
{
Box3 EmptyBox()
{
  return { Vec3(kInfinity), Vec3(-kInfinity) };
}
} // namespace

ElementIndex::ElementIndex(const Mesh& mesh)
  : mesh_(mesh)
  , Boxes(static_cast<std::size_t>(mesh.Elements()))
  , Made(new std::atomic<const ElementBounds*>[static_cast<std::size_t>(mesh.Elements())]())
{
  tbb::parallel_for(0, mesh.Elements(),
    [&](int e) { Boxes[static_cast<std::size_t>(e)] = MakeElementBox(mesh_, e); });
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

void ElementIndex::FindNear(const Box3& region, std::vector<int>& elements) const
{
  elements.clear();
  if (Hierarchy)
  {
    Hierarchy->Query(region, elements);
  }
}

void ElementIndex::FindAlong(const Segment& segment, std::vector<int>& elements) const
{
  elements.clear();
  if (Hierarchy)
  {
    Hierarchy->QueryAlong(segment, elements);
  }
}

const ElementBounds& ElementIndex::MakeBounds(int element) const
{
  const StageScope scope(Stage::Bounds);
  auto mine = std::make_unique<const ElementBounds>(MakeElementBounds(mesh_, element));
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
    tree = std::make_shared<ElementTree>(mesh_, element, bounds, Grown);
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
