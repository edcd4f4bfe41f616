// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ModeBound.h"
#include "Core/Basis/Space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace pixelexact::nektar
{
namespace
{
/// A bound of |function| on all elements.
double LargestOf(const OwnedExpansion& plane)
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
    const auto coefficients = plane.Coefficients(e);
    double sum = 0.0;
    for (std::size_t m = 0; m < coefficients.size(); ++m)
    {
      sum += std::fabs(coefficients[m]) * bounds[static_cast<std::size_t>(plane.spaceOf[e])][m];
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Products of the functions, those of y fastest, at places along z and y, one place after the
/// other.
std::vector<double> WavesOf(const FourierLayers* y, const FourierLayers& z)
{
  constexpr int kPlaces = 64;
  constexpr int kPlacesEach = 16;
  const auto at = [](const FourierLayers& layers, std::size_t f, int k, int places)
  { return layers.Value(f, layers.Length() * k / places); };
  std::vector<double> waves;
  const int placesZ = y != nullptr ? kPlacesEach : kPlaces;
  for (int k = 0; k < placesZ; ++k)
  {
    for (int j = 0; j < (y != nullptr ? kPlacesEach : 1); ++j)
    {
      for (std::size_t f = 0; f < z.Functions(); ++f)
      {
        const double value = at(z, f, k, placesZ);
        for (std::size_t g = 0; g < (y != nullptr ? y->Functions() : 1); ++g)
        {
          waves.push_back(y != nullptr ? value * at(*y, g, j, kPlacesEach) : value);
        }
      }
    }
  }
  return waves;
}

/// The range of the field's values at sampled elements' middles; the true range is no smaller.
double AttainedRange(const HomogeneousField& field, const FourierLayers* y, const FourierLayers& z)
{
  constexpr std::size_t kElements = 2000;
  const std::vector<double> waves = WavesOf(y, z);
  const std::size_t functions = z.Functions() * (y != nullptr ? y->Functions() : 1);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<double> middle(functions);
  const OwnedExpansion& first = field.planes.front();
  const std::size_t elements = first.spaceOf.size();
  for (std::size_t e = 0; e < elements; e += 1 + elements / kElements)
  {
    for (std::size_t begin = 0; begin < field.planes.size(); begin += functions)
    {
      for (std::size_t f = 0; f < functions; ++f)
      {
        const OwnedExpansion& plane = field.planes[begin + f];
        const Space& space = plane.SpaceOf(e);
        std::vector<long double> modes(static_cast<std::size_t>(space.Modes()));
        EvaluateModes(space, { -0.4L, -0.4L, -0.4L }, modes.data());
        middle[f] = static_cast<double>(
          std::inner_product(modes.begin(), modes.end(), plane.Coefficients(e).begin(), 0.0L));
      }
      for (auto at = waves.begin(); at != waves.end(); at += static_cast<std::ptrdiff_t>(functions))
      {
        const double value = std::inner_product(middle.begin(), middle.end(), at, 0.0);
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  return high > low ? high - low : 0.0;
}

/// Bounds of the difference between a field and its polynomials of given orders, along y and along
/// z.
struct Losses
{
  double y = 0.0;
  double z = 0.0;
};

/// A product f g of functions bounded by 1 loses along z the loss of g, and along y the loss of f
/// times a bound of g's polynomial, 1 + g's loss. `largest`: per plane.
Losses LossesOf(const std::vector<double>& largest, const FourierLayers* y, const FourierLayers& z,
  const Accuracy& orders)
{
  const std::size_t along = y != nullptr ? y->Functions() : 1;
  Losses worst;
  double sum = -1.0;
  for (std::size_t begin = 0; begin < largest.size(); begin += along * z.Functions())
  {
    Losses strip;
    for (std::size_t f = 0; f < along * z.Functions(); ++f)
    {
      const double lossZ = z.Loss(f / along, orders.orderZ);
      strip.z += largest[begin + f] * lossZ;
      strip.y +=
        y != nullptr ? largest[begin + f] * (1 + lossZ) * y->Loss(f % along, orders.orderY) : 0.0;
    }
    if (strip.y + strip.z > sum)
    {
      worst = strip;
      sum = strip.y + strip.z;
    }
  }
  return worst;
}
} // namespace

FourierLayers::FourierLayers(const Periodic& along)
  : Along(along)
{
  for (std::size_t f = 0; f < along.functions.size(); ++f)
  {
    Count = std::max(Count, Wave(f));
  }
  for (std::size_t f = 0; f < along.functions.size(); ++f)
  {
    for (unsigned n = 0; n <= kMaxOrder; ++n)
    {
      Bessel.push_back(std::sph_bessel(n, Phase(Wave(f))));
    }
  }
}

long double FourierLayers::Phase(int wave) const
{
  return std::numbers::pi_v<long double> * wave / Count;
}

double FourierLayers::Value(std::size_t function, double s) const
{
  const long double angle = 2 * std::numbers::pi_v<long double> * Wave(function) *
    (s / static_cast<long double>(Along.length));
  return static_cast<double>(
    Along.functions[function] % 2 == 0 ? std::cos(angle) : -std::sin(angle));
}

double FourierLayers::Coefficient(int layer, std::size_t function, int n) const
{
  // cos(a + t x) and -sin(a + t x): the real part of exp(i (a + t x)), and minus the imaginary one.
  const long double t = Phase(Wave(function));
  const long double a = t * (2 * layer + 1);
  const long double amplitude = (2 * n + 1) * Bessel[function * (kMaxOrder + 1) + n];
  const long double parts[4] = { std::cos(a), -std::sin(a), -std::cos(a), std::sin(a) };
  const int turn = Along.functions[function] % 2 == 0 ? n : n + 1;
  return static_cast<double>(amplitude * parts[turn % 4]);
}

double FourierLayers::Loss(std::size_t function, int order) const
{
  // The terms (2 n + 1) t^n / (2 n + 1)!! = t^n / (2 n - 1)!! fall by t / (2 n + 1) each.
  const long double t = Phase(Wave(function));
  if (t == 0)
  {
    return 0.0;
  }
  long double term = 1.0L;
  long double sum = 0.0L;
  for (int n = 1; n < 200; ++n)
  {
    term *= t / (2 * n - 1);
    sum += n > order ? term : 0.0L;
  }
  return static_cast<double>(sum) * (1 + 1e-12);
}

Accuracy AccuracyOf(const HomogeneousField& field, const FourierLayers* y, const FourierLayers& z)
{
  std::vector<double> largest;
  std::ranges::transform(field.planes, std::back_inserter(largest), &LargestOf);
  Accuracy found;
  found.range = AttainedRange(field, y, z);
  for (;;)
  {
    const Losses losses = LossesOf(largest, y, z, found);
    found.loss = losses.y + losses.z;
    if (!(found.loss > kHomogeneousLoss * found.range))
    {
      return found;
    }
    // Raises the order of the direction with the larger loss.
    const bool atY = found.orderZ == kMaxOrder || (losses.y > losses.z && found.orderY < kMaxOrder);
    if ((atY ? found.orderY : found.orderZ) == kMaxOrder || (atY && y == nullptr))
    {
      return found;
    }
    ++(atY ? found.orderY : found.orderZ);
  }
}
} // namespace pixelexact::nektar
