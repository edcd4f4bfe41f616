// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Locator.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Location/Batch.h"
#include "Core/Location/BoundsCache.h"
#include "Core/Location/EmbreeBvh.h"
#include "Core/Location/InversionTrees.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace pixelexact
{
Locator::Locator(const Mesh& mesh)
  : TheMesh(mesh)
  , Boxes(mesh.Elements())
  , Cache(std::make_unique<BoundsCache>(TheMesh))
  , Trees(std::make_unique<InversionTrees>(TheMesh, *Cache))
{
  tbb::parallel_for(0, mesh.Elements(), [&](int e) { Boxes[e] = MakeElementBox(TheMesh, e); });
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  MeshBounds = { Vec3(kInfinity), Vec3(-kInfinity) };
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

Locator::~Locator() = default;

void Locator::Locate(const LanePoints& points, LocationSink& sink) const
{
  Batch(*this, points, sink).Run();
}

void Locator::Locate(std::span<const Vec3> points, LocationSink& sink) const
{
  const LaneBuffer lanes(points);
  Locate(lanes.View(), sink);
}

const Box3& Locator::ElementBox(int element) const
{
  return Boxes[element];
}

int Locator::BoundedElements() const
{
  return Cache->Count();
}

std::size_t Locator::MemoryUsage() const
{
  return Boxes.capacity() * sizeof(Box3) + Cache->MemoryUsage() +
    (Hierarchy ? Hierarchy->MemoryUsage() : 0) + Trees->MemoryUsage();
}
} // namespace pixelexact
