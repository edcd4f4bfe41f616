// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/ElementBounds.h"

#include <atomic>
#include <memory>

namespace pixelexact
{
/// The bounds of a mesh's elements, each made when a point first needs it and then kept: a cut
/// through a mesh asks for those of the elements around it only. Safe to call from several threads;
/// which bounds have been made changes no answer.
class BoundsCache
{
public:
  explicit BoundsCache(const Mesh& mesh);
  ~BoundsCache();
  BoundsCache(const BoundsCache&) = delete;
  BoundsCache& operator=(const BoundsCache&) = delete;

  [[nodiscard]] const ElementBounds& Of(int element) const
  {
    const auto* made = Made[static_cast<std::size_t>(element)].load(std::memory_order_acquire);
    return made ? *made : Make(element);
  }
  [[nodiscard]] bool Has(int element) const
  {
    return Made[static_cast<std::size_t>(element)].load(std::memory_order_relaxed) != nullptr;
  }
  /// Elements whose bounds have been made.
  [[nodiscard]] int Count() const { return MadeCount; }
  [[nodiscard]] std::size_t MemoryUsage() const;

private:
  const ElementBounds& Make(int element) const;

  const Mesh& TheMesh;
  std::unique_ptr<std::atomic<const ElementBounds*>[]> Made;
  mutable std::atomic<int> MadeCount{ 0 };
};
} // namespace pixelexact
