// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/HitSlots.h"

#include "Core/Element/Kernels.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
template <class T>
void Fit(std::vector<T>& array, std::size_t size)
{
  if (array.size() < size)
  {
    array.resize(size);
  }
}
} // namespace

void HitSlots::Begin(int rays)
{
  // Arrays whose distance is a multiple of 4096 bytes would evict each other from the cache.
  constexpr std::size_t kApart = 5 * 8;
  Rays = rays;
  Used = 0;
  First = 0;
  // The stride never decreases, because existing slots were allocated with it.
  Stride = std::max(Stride, static_cast<std::size_t>(PaddedCount(rays)) + kApart);
}

HitLanes HitSlots::Slot(int k)
{
  if (k == Used)
  {
    if (Slots.size() == static_cast<std::size_t>(Used))
    {
      Slots.emplace_back();
    }
    OneSlot& slot = At(k);
    Fit(slot.t, Stride);
    Fit(slot.position, 3 * Stride);
    std::fill_n(slot.t.data(), static_cast<std::size_t>(PaddedCount(Rays)), kNoHit);
    slot.hasStatus = false;
    slot.hasElements = false;
    slot.hasPieces = false;
    ++Used;
  }
  OneSlot& slot = At(k);
  double* const x = slot.position.data() + First;
  return { slot.t.data() + First, { x, x + Stride, x + 2 * Stride } };
}

HitStatus* HitSlots::Status(int k)
{
  OneSlot& slot = At(k);
  if (!slot.hasStatus)
  {
    slot.hasStatus = true;
    slot.status.assign(Stride, HitStatus::Certain);
  }
  return slot.status.data() + First;
}

ElementLanes HitSlots::Elements(int k)
{
  OneSlot& slot = At(k);
  if (!slot.hasElements)
  {
    slot.hasElements = true;
    slot.element.assign(Stride, -1);
    Fit(slot.xi, 3 * Stride);
  }
  double* const xi = slot.xi.data() + First;
  return { slot.element.data() + First, { xi, xi + Stride, xi + 2 * Stride } };
}

PieceLanes HitSlots::Pieces(int k)
{
  OneSlot& slot = At(k);
  if (!slot.hasPieces)
  {
    slot.hasPieces = true;
    slot.piece.assign(Stride, -1);
    Fit(slot.parameters, 2 * Stride);
  }
  double* const parameters = slot.parameters.data() + First;
  return { slot.piece.data() + First, { parameters, parameters + Stride } };
}

bool HitSlots::HasStatuses() const
{
  return std::any_of(
    Slots.begin(), Slots.begin() + Used, [](const OneSlot& slot) { return slot.hasStatus; });
}

bool HitSlots::HasElements() const
{
  return std::any_of(
    Slots.begin(), Slots.begin() + Used, [](const OneSlot& slot) { return slot.hasElements; });
}

SurfacePoint HitSlots::PointOf(int k, int ray) const
{
  const OneSlot& slot = At(k);
  const auto i = static_cast<std::size_t>(ray);
  SurfacePoint point{ { slot.position[i], slot.position[Stride + i],
    slot.position[2 * Stride + i] } };
  if (slot.hasElements)
  {
    point.element = slot.element[i];
    point.xi = { slot.xi[i], slot.xi[Stride + i], slot.xi[2 * Stride + i] };
  }
  if (slot.hasPieces)
  {
    point.piece = slot.piece[i];
    point.parameters[0] = slot.parameters[i];
    point.parameters[1] = slot.parameters[Stride + i];
  }
  return point;
}
} // namespace pixelexact
