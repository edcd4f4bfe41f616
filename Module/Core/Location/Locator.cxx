// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/Locator.h"

#include "Core/Element/LaneBuffer.h"
#include "Core/Location/Batch.h"

namespace pixelexact
{
void Locator::Locate(const LanePoints& points, LocationSink& sink) const
{
  Batch(*this, points, sink).Run();
}

void Locator::Locate(std::span<const Vec3> points, LocationSink& sink) const
{
  const LaneBuffer lanes(points);
  Locate(lanes.View(), sink);
}
} // namespace pixelexact
