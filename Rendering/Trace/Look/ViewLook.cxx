// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Look/ViewLook.h"

#include <algorithm>

namespace pixelexact
{
bool LayerLook::ReadsTable() const
{
  return table != nullptr &&
    (!solid || contours.count > 0 || (contours.Any() && contours.colors.empty()));
}

bool LayerLook::operator==(const LayerLook& other) const
{
  const bool sameTable = (table == nullptr) == (other.table == nullptr) &&
    (table == nullptr || table->IsSame(*other.table));
  return sameTable && range == other.range && rangeGroup == other.rangeGroup &&
    solid == other.solid && unknown == other.unknown && opacity == other.opacity &&
    material == other.material && contours == other.contours;
}

bool ViewLook::HasContours() const
{
  return std::ranges::any_of(layers, [](const LayerLook& layer) { return layer.contours.Any(); });
}

bool ViewLook::IsLit() const
{
  return std::ranges::any_of(
    layers, [](const LayerLook& layer) { return layer.material.has_value(); });
}

bool ViewLook::NeedsFrame() const
{
  return std::ranges::any_of(layers,
    [](const LayerLook& layer)
    { return (layer.ReadsTable() && layer.range.IsOfFrame()) || layer.contours.count > 0; });
}
} // namespace pixelexact
