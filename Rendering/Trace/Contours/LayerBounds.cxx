// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/LayerBounds.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
/// Of sums in single precision, as a part of the largest they can be: some roundoffs of a float.
constexpr double kFloatRounding = 0x1p-19;
} // namespace

LayerBounds::LayerBounds(const Locator& locator, const Layer& layer)
  : TheIndex(locator.Index())
  , TheField(*layer.field)
  , Component(layer.component == kMagnitude ? -1 : layer.component)
  , Provable(TheField.mapping == Mapping::Identity)
  , Rounding(layer.precision == Precision::Float ? kFloatRounding : 0.0)
  , Made(static_cast<std::size_t>(locator.GetMesh().Elements()))
{
}

const EdgeBounds& LayerBounds::Of(int element) const
{
  return Made.Get(static_cast<std::size_t>(element),
    [&]
    {
      return std::make_unique<const EdgeBounds>(
        TheIndex.GetMesh(), TheIndex.BoundsOf(element), element, TheField, Component, Rounding);
    });
}

const Interval& LayerBounds::Values() const
{
  std::call_once(Found,
    [this]
    {
      for (int e = 0; e < static_cast<int>(Made.Size()); ++e)
      {
        const Interval& own = Of(e).Values();
        if (own.IsFinite())
        {
          All = All.IsEmpty()
            ? own
            : Interval(std::min(All.lower, own.lower), std::max(All.upper, own.upper));
        }
      }
    });
  return All;
}

const LayerBounds& ContourBounds::Of(const Locator& locator, const Layer& layer)
{
  const std::scoped_lock lock(Making);
  auto& kept = Kept[{ layer.field, layer.component, layer.precision }];
  if (!kept)
  {
    kept = std::make_unique<const LayerBounds>(locator, layer);
  }
  return *kept;
}

std::int64_t LayerBounds::Nodes() const
{
  std::int64_t nodes = 0;
  for (std::size_t e = 0; e < Made.Size(); ++e)
  {
    const EdgeBounds* made = Made.IfMade(e);
    nodes += made ? made->Nodes() : 0;
  }
  return nodes;
}
} // namespace pixelexact
