// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/HomogeneousAccuracy.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ModeBound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pixelexact::nektar
{
namespace
{
/// A bound of |function| on all elements.
double LargestOf(const SolverExpansion& plane)
{
  std::vector<std::vector<double>> bounds;
  for (const Space& space : plane.spaces)
  {
    auto& own = bounds.emplace_back();
    ForEachMode(
      space, [&](int p, int q, int r, int /*mode*/) { own.push_back(ModeBound(space, p, q, r)); });
  }
  double largest = 0.0;
  for (std::size_t e = 0; e < plane.spaceOf.size(); ++e)
  {
    const auto coefficients = CoefficientsOf(plane, e);
    double sum = 0.0;
    for (std::size_t m = 0; m < coefficients.size(); ++m)
    {
      sum += std::fabs(coefficients[m]) * bounds[static_cast<std::size_t>(plane.spaceOf[e])][m];
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

/// A range of values that are attained in elements' middles; the true one is no smaller.
double AttainedRange(const HomogeneousField& field, const FourierLayers& layers)
{
  constexpr std::size_t kElements = 2000;
  constexpr int kPlaces = 64;
  const std::size_t functions = field.planes.size();
  std::vector<double> waves;
  for (int k = 0; k < kPlaces; ++k)
  {
    for (std::size_t f = 0; f < functions; ++f)
    {
      waves.push_back(layers.Value(f, 2 * layers.Half() * layers.Layers() * k / kPlaces));
    }
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<double> middle(functions);
  const std::size_t elements = field.planes.front().spaceOf.size();
  for (std::size_t e = 0; e < elements; e += 1 + elements / kElements)
  {
    const SolverExpansion& first = field.planes.front();
    const Space& space = first.spaces[static_cast<std::size_t>(first.spaceOf[e])];
    std::vector<long double> modes(static_cast<std::size_t>(space.Modes()));
    EvaluateModes(space, { -0.4L, -0.4L, -0.4L }, modes.data());
    for (std::size_t f = 0; f < functions; ++f)
    {
      middle[f] = static_cast<double>(std::inner_product(
        modes.begin(), modes.end(), CoefficientsOf(field.planes[f], e).begin(), 0.0L));
    }
    for (auto at = waves.begin(); at != waves.end(); at += static_cast<std::ptrdiff_t>(functions))
    {
      const double value = std::inner_product(middle.begin(), middle.end(), at, 0.0);
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return high > low ? high - low : 0.0;
}

/// What polynomials of an order lose of a field at most.
double LossOf(const std::vector<double>& largest, const FourierLayers& layers, int order)
{
  double loss = 0.0;
  for (std::size_t f = 0; f < largest.size(); ++f)
  {
    loss += largest[f] * layers.Loss(f, order);
  }
  return loss;
}
} // namespace

std::span<const double> CoefficientsOf(const SolverExpansion& expansion, std::size_t e)
{
  const Space& space = expansion.spaces[static_cast<std::size_t>(expansion.spaceOf[e])];
  return { &expansion.coefficients.data[static_cast<std::size_t>(expansion.offset[e])],
    static_cast<std::size_t>(space.Modes() * expansion.components) };
}

Accuracy AccuracyOf(const HomogeneousField& field, const FourierLayers& layers)
{
  std::vector<double> largest;
  std::ranges::transform(field.planes, std::back_inserter(largest), &LargestOf);
  Accuracy found;
  found.range = AttainedRange(field, layers);
  found.loss = LossOf(largest, layers, 0);
  while (found.order < kMaxOrder && found.loss > kHomogeneousLoss * found.range)
  {
    found.loss = LossOf(largest, layers, ++found.order);
  }
  return found;
}
} // namespace pixelexact::nektar
