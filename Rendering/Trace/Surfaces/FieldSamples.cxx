// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/FieldSamples.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Element/FieldFunction.h"
#include "Core/Index/Segment.h"
#include "Core/Location/Sample.h"
#include "Trace/Scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pixelexact
{
FieldSamples::FieldSamples(const Locator& locator, const Field& field, int component, double value)
  : MeshLocator(locator)
  , SampledField(field)
  , Component(component)
  , Value(value)
{
  if (field.function != nullptr)
  {
    field.function->RequireGradient();
  }
}

void FieldSamples::Evaluate(std::span<const Vec3> x, std::span<double> values) const
{
  const auto components = static_cast<std::size_t>(SampledField.values.components);
  std::vector<double> all(components * x.size());
  SampleTarget target;
  target.value = all;
  SampleTile(MeshLocator, &SampledField, x, target);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    values[i] = ComponentOf(std::span(all).subspan(i * components, components), Component) - Value;
  }
}

void FieldSamples::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  const auto components = static_cast<std::size_t>(SampledField.values.components);
  std::vector<double> values(components * x.size());
  std::vector<double> slopes(3 * values.size());
  SampleTarget target;
  target.value = values;
  target.gradient = slopes;
  SampleTile(MeshLocator, &SampledField, x, target);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const auto slopeOf = [&](std::size_t c)
    {
      const double* slope = &slopes[3 * (i * components + c)];
      return Vec3(slope[0], slope[1], slope[2]);
    };
    if (Component != kMagnitude || components == 1)
    {
      gradients[i] = slopeOf(static_cast<std::size_t>(std::max(Component, 0)));
      continue;
    }
    // The gradient of half the square has the direction of the magnitude's gradient.
    gradients[i] = Vec3(0.0);
    for (std::size_t c = 0; c < components; ++c)
    {
      gradients[i] += values[i * components + c] * slopeOf(c);
    }
  }
}

void FieldSamples::AddPlaces(const Segment& segment, std::vector<double>& places) const
{
  constexpr int kOfElement = 8;
  const CheckedOut<std::vector<int>> scratch;
  std::vector<int>& elements = *scratch;
  const ElementIndex& index = MeshLocator.Index();
  index.FindAlong(segment, elements);
  const Vec3 way = segment.to - segment.from;
  const auto number = static_cast<int>(elements.size());
  const int steps = std::max(kOfElement, SearchedSurface::kDefaultSamples / std::max(number, 1));
  for (const int element : elements)
  {
    const auto part = ClipRay(index.ElementBox(element), segment.from, way, 0.0, 1.0);
    for (int k = 0; part && k <= steps; ++k)
    {
      const Vec3 x = part->from + (1.0 * k / steps) * (part->to - part->from);
      const double s = glm::dot(x - segment.from, way) / glm::dot(way, way);
      places.push_back(std::clamp(s, 0.0, 1.0));
    }
  }
}
} // namespace pixelexact
