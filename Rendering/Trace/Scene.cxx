// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Scene.h"

#include "Core/Element/FieldFunction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pixelexact
{
namespace
{
double Magnitude(std::span<const double> values)
{
  constexpr double kSmall = 1e-280;
  constexpr double kLarge = 1e280;
  double squares = 0.0;
  for (const double value : values)
  {
    squares += value * value;
  }
  if (squares >= kSmall && squares <= kLarge)
  {
    return std::sqrt(squares);
  }
  // hypot neither overflows nor underflows, but is much slower than std::fabs.
  return std::accumulate(values.begin() + 1, values.end(), std::fabs(values.front()),
    [](double sum, double v) { return std::hypot(sum, v); });
}
} // namespace

double ComponentOf(std::span<const double> values, int component)
{
  return component == kMagnitude && values.size() > 1
    ? Magnitude(values)
    : values[static_cast<std::size_t>(std::max(component, 0))];
}

bool HasTranslucent(const Scene& scene)
{
  return std::ranges::any_of(scene.layers, &Layer::translucent);
}

bool HasJumps(const Scene& scene)
{
  return std::ranges::any_of(scene.layers,
    [](const Layer& layer)
    {
      return layer.field != nullptr && layer.field->function != nullptr &&
        layer.field->function->NeedsNeighbours();
    });
}
} // namespace pixelexact
