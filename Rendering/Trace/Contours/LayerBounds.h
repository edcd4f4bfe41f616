// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeBounds.h"
#include "Trace/Scene.h"

#include <atomic>
#include <cstddef>
#include <memory>

namespace pixelexact
{
/// What is known of a layer's field for contours, element by element, made where somebody first
/// asks: it depends on neither view nor values. Safe to use from several threads. Locator and field
/// must outlive it.
class LayerBounds
{
public:
  /// Throws Unsupported for a field whose contours cannot be certified: mapped ones.
  LayerBounds(const Locator& locator, const Layer& layer);
  ~LayerBounds();
  LayerBounds(const LayerBounds&) = delete;
  LayerBounds& operator=(const LayerBounds&) = delete;

  [[nodiscard]] const EdgeBounds& Of(int element) const;
  [[nodiscard]] const ElementIndex& Index() const { return TheIndex; }

  /// Elements that have been asked for, and their nodes.
  [[nodiscard]] std::int64_t Elements() const;
  [[nodiscard]] std::int64_t Nodes() const;

private:
  const ElementIndex& TheIndex;
  const Field& TheField;
  int Component;
  double Rounding;
  std::size_t Count;
  std::unique_ptr<std::atomic<const EdgeBounds*>[]> Made;
};
} // namespace pixelexact
