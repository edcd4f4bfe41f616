// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/LayerBounds.h"

#include "Core/Math/Rounding.h"

#include <tbb/blocked_range.h>
#include <tbb/collaborative_call_once.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

namespace pixelexact
{
namespace
{
/// Rounding of sums in single precision. EdgeFunctions bounds n roundings of doubles, 2^-53 each,
/// and multiplies the bound by this number over 2^-53. The result is 32 times n roundings of a
/// float, 2^-24 each.
constexpr double kFloatRounding = 0x1p-19;
} // namespace

struct LayerBounds::SharedRange
{
  tbb::collaborative_once_flag computed;
  Interval values{ 1.0, -1.0 };
};

LayerBounds::LayerBounds(const Locator& locator, const Layer& layer)
  : index_(locator.Index())
  , field_(*layer.field)
  , Component(layer.component == kMagnitude ? -1 : layer.component)
  , Rounding(layer.precision == Precision::Float ? kFloatRounding : 0.0)
  , Made(static_cast<std::size_t>(locator.GetMesh().Elements()))
  , Plateaus(Made.Size())
  , All(std::make_unique<SharedRange>())
{
}

LayerBounds::~LayerBounds() = default;

const ElementPlateaus& LayerBounds::PlateausOf(int element) const
{
  return Plateaus.Get(static_cast<std::size_t>(element),
    [&] {
      return std::make_unique<const ElementPlateaus>(index_.GetMesh(), element, field_, Component);
    });
}

const EdgeBounds& LayerBounds::Of(int element) const
{
  return Made.Get(static_cast<std::size_t>(element),
    [&]
    {
      return std::make_unique<const EdgeBounds>(
        index_.GetMesh(), index_.BoundsOf(element), element, field_, Component, Rounding);
    });
}

double LayerBounds::ToBounded(double value) const
{
  const bool isNorm = Component < 0 && field_.values.components > 1;
  return field_.function == nullptr
    ? value
    : field_.function->JetValue(isNorm ? FieldFunction::kNorm : std::max(Component, 0), value);
}

const Interval& LayerBounds::Values() const
{
  tbb::collaborative_call_once(All->computed,
    [this]
    {
      All->values = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, Made.Size()), Interval(kInfinity, -kInfinity),
        [this](const tbb::blocked_range<std::size_t>& elements, Interval all)
        {
          for (std::size_t e = elements.begin(); e < elements.end(); ++e)
          {
            const EdgeBounds& own = Of(static_cast<int>(e));
            all = own.HasValues() ? Join(all, own.Values()) : all;
          }
          return all;
        },
        Join);
    });
  return All->values;
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
} // namespace pixelexact
