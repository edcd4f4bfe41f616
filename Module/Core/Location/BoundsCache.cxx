// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/BoundsCache.h"

#include "Core/Base/StageClock.h"

namespace pixelexact
{
BoundsCache::BoundsCache(const Mesh& mesh)
  : TheMesh(mesh)
  , Made(new std::atomic<const ElementBounds*>[static_cast<std::size_t>(mesh.Elements())]())
{
}

BoundsCache::~BoundsCache()
{
  for (int e = 0; e < TheMesh.Elements(); ++e)
  {
    delete Made[static_cast<std::size_t>(e)].load();
  }
}

const ElementBounds& BoundsCache::Make(int element) const
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

std::size_t BoundsCache::MemoryUsage() const
{
  return static_cast<std::size_t>(TheMesh.Elements()) * sizeof(void*) +
    static_cast<std::size_t>(MadeCount.load()) * sizeof(ElementBounds);
}
} // namespace pixelexact
