// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Questions/EdgeBounds.h"
#include "Core/Questions/Plateau.h"
#include "Trace/Scene.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

namespace pixelexact
{
/// What is known of a layer's field for contours, element by element, made where somebody first
/// asks: it depends on neither view nor values. Safe to use from several threads. Locator and field
/// must outlive it.
class LayerBounds
{
public:
  LayerBounds(const Locator& locator, const Layer& layer);
  ~LayerBounds();
  LayerBounds(const LayerBounds&) = delete;
  LayerBounds& operator=(const LayerBounds&) = delete;

  /// Whether nothing is known of the field but its values: of expressions with jumps, with normals
  /// or without a gradient.
  [[nodiscard]] bool IsUnknown() const
  {
    return field_.function != nullptr && !field_.function->HasJets();
  }
  [[nodiscard]] const EdgeBounds& Of(int element) const;
  [[nodiscard]] const ElementPlateaus& PlateausOf(int element) const;
  [[nodiscard]] const ElementIndex& Index() const { return index_; }
  /// Holds the values in all elements but those that are not finite; found out once, by all threads
  /// that ask.
  [[nodiscard]] const Interval& Values() const;

  /// Elements that have been asked for.
  [[nodiscard]] std::int64_t Elements() const
  {
    return static_cast<std::int64_t>(Made.MadeCount());
  }

private:
  const ElementIndex& index_;
  const Field& field_;
  int Component;
  double Rounding;
  MadeOnDemand<EdgeBounds> Made;
  MadeOnDemand<ElementPlateaus> Plateaus;
  struct SharedRange;
  std::unique_ptr<SharedRange> All; ///< computed by the first call of Values
};

/// What is known of the fields of one locator's mesh, kept from frame to frame. Safe to use from
/// several threads. Whoever keeps it drops it with the locator or its fields.
class ContourBounds
{
public:
  const LayerBounds& Of(const Locator& locator, const Layer& layer);

private:
  std::mutex Making;
  std::map<std::tuple<const Field*, int, Precision>, std::unique_ptr<const LayerBounds>> Kept;
};
} // namespace pixelexact
