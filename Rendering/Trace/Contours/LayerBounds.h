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
/// Bounds of a layer's field for contours, per element, computed on first use. They depend on
/// neither view nor iso-values. Safe to use from several threads. Locator and field must outlive
/// the object.
class LayerBounds
{
public:
  LayerBounds(const Locator& locator, const Layer& layer);
  ~LayerBounds();
  LayerBounds(const LayerBounds&) = delete;
  LayerBounds& operator=(const LayerBounds&) = delete;

  /// The field has no bounds: an expression with jumps, with normals or without a gradient.
  [[nodiscard]] bool IsUnknown() const
  {
    return field_.function != nullptr && !field_.function->HasJets();
  }
  /// Bounds of the component, or of the scalar that stands for it (ToBounded).
  [[nodiscard]] const EdgeBounds& Of(int element) const;
  /// The value of the scalar that Of and Values bound where the component has this value. For
  /// expressions see FieldFunction::JetValue.
  [[nodiscard]] double ToBounded(double value) const;
  [[nodiscard]] const ElementPlateaus& PlateausOf(int element) const;
  [[nodiscard]] const ElementIndex& Index() const { return index_; }
  /// Contains the scalar's values in all elements with finite values. Computed once, by all threads
  /// that call it.
  [[nodiscard]] const Interval& Values() const;

  /// Count of elements whose bounds have been computed.
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

/// Bounds for the fields of one locator's mesh, kept from frame to frame. Safe to use from several
/// threads. The owner discards them with the locator or its fields.
class ContourBounds
{
public:
  const LayerBounds& Of(const Locator& locator, const Layer& layer);

private:
  std::mutex Making;
  std::map<std::tuple<const Field*, int, Precision>, std::unique_ptr<const LayerBounds>> Kept;
};
} // namespace pixelexact
