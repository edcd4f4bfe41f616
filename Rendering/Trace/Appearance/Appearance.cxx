// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Appearance/Appearance.h"

#include <algorithm>

namespace pixelexact
{
bool LayerAppearance::ReadsTable() const
{
  return table != nullptr &&
    (!solid || contours.count > 0 || (contours.Any() && contours.colors.empty()));
}

bool LayerAppearance::IsOpaque() const
{
  return opacity >= 1.0 && (solid || table == nullptr || table->IsOpaque());
}

bool LayerAppearance::operator==(const LayerAppearance& other) const
{
  const bool sameTable = (table == nullptr) == (other.table == nullptr) &&
    (table == nullptr || table->IsSame(*other.table));
  return sameTable && bands == other.bands && range == other.range &&
    rangeGroup == other.rangeGroup && solid == other.solid && unknown == other.unknown &&
    opacity == other.opacity && material == other.material && contours == other.contours;
}

bool Appearance::HasContours() const
{
  return std::ranges::any_of(
    layers, [](const LayerAppearance& layer) { return layer.contours.Any(); });
}

bool Appearance::IsByValue() const
{
  return std::ranges::any_of(layers, [](const LayerAppearance& layer) { return !layer.solid; });
}

bool Appearance::IsLit() const
{
  return std::ranges::any_of(
    layers, [](const LayerAppearance& layer) { return layer.material.has_value(); });
}

bool Appearance::NeedsFrame() const
{
  return std::ranges::any_of(layers,
    [](const LayerAppearance& layer)
    { return (layer.ReadsTable() && layer.range.IsOfFrame()) || layer.contours.count > 0; });
}
} // namespace pixelexact
