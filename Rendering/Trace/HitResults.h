// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/Verdict.h"
#include "Trace/Frame.h"
#include "Trace/Scene.h"

#include <span>

namespace pixelexact
{
/// What a tile found at hits of one layer, hit by hit: what the frame's buffers are written from.
/// Spans are empty where nobody asked.
struct HitResults
{
  const Layer* layer = nullptr;
  std::uint8_t layerNumber = 0;
  const HitSlots* slots = nullptr;
  const double* t = nullptr;
  const double* position[3] = {};
  /// Ray and slot of each hit; null: hit i is ray i's in slot `slot`, and every ray has one.
  const int* ray = nullptr;
  const int* slotOf = nullptr;
  int slot = 0;

  std::span<Verdict> verdict;
  std::span<std::int32_t> element;
  std::span<Vec3> xi;
  std::span<double> value; ///< of the component that is shown
  std::span<double> lower; ///< of the same
  std::span<double> upper;
  /// Of hits that are not outside, where they were asked for together.
  std::span<const Vec3> normals;

  [[nodiscard]] int RayOf(std::size_t i) const { return ray ? ray[i] : static_cast<int>(i); }
  [[nodiscard]] int SlotOf(std::size_t i) const { return slotOf ? slotOf[i] : slot; }
  [[nodiscard]] Vec3 Position(std::size_t i) const
  {
    return { position[0][i], position[1][i], position[2][i] };
  }
  [[nodiscard]] SurfacePoint Point(std::size_t i) const
  {
    return slots->PointOf(SlotOf(i), RayOf(i));
  }
  [[nodiscard]] Vec3 Normal(std::size_t i) const
  {
    return normals.empty() ? layer->surface->Normal(Point(i)) : normals[i];
  }
  [[nodiscard]] HitStatus Status(std::size_t i) const
  {
    return slots->StatusOf(SlotOf(i), RayOf(i));
  }
};
} // namespace pixelexact
