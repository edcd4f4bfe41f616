// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Location/BoxCoefficients.h"

#include "Core/Bernstein/BernsteinForm.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
double LargestOf(std::span<const double> values)
{
  double largest = 0.0;
  for (const double b : values)
  {
    largest = std::max(largest, std::fabs(b));
  }
  return largest;
}
} // namespace

void BoxCoefficients::Add(std::span<const double> coefficients, double itsError)
{
  values.insert(values.end(), coefficients.begin(), coefficients.end());
  error.push_back(itsError);
  base.push_back(0.0);
}

std::span<const double> BoxCoefficients::Of(std::size_t function) const
{
  const std::size_t size = values.size() / error.size();
  return std::span(values).subspan(function * size, size);
}

Interval BoxCoefficients::HullOf(std::size_t function) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least = kInfinity;
  double most = -kInfinity;
  bool sound = error[function] < kInfinity;
  for (const double b : Of(function))
  {
    least = std::min(least, b);
    most = std::max(most, b);
    sound = sound && std::fabs(b) < kInfinity;
  }
  return sound ? rounding::Outward(least - error[function], most + error[function])
               : Interval::Everything();
}

void BoxCoefficients::Recentre()
{
  const std::size_t size = values.size() / error.size();
  for (std::size_t f = 0; f < error.size(); ++f)
  {
    const auto part = std::span(values).subspan(f * size, size);
    const double first = part.front();
    const double moved = base[f] + first;
    const double shift = moved - base[f];
    // The new base is the sum of the old one and the shift only if no bit of the shift is lost.
    if (!(std::fabs(first) <= std::fabs(base[f]) || base[f] == 0.0) || !std::isfinite(moved))
    {
      continue;
    }
    for (double& b : part)
    {
      b -= shift;
    }
    base[f] = moved;
    error[f] = NextUp(error[f] + Gamma(1) * LargestOf(part));
  }
}

BoxCoefficients BoxCoefficients::Halve(const std::array<int, 3>& degree, int direction)
{
  const std::size_t size = values.size() / error.size();
  BoxCoefficients upper;
  upper.values.resize(values.size());
  for (std::size_t f = 0; f < error.size(); ++f)
  {
    const auto part = std::span(values).subspan(f * size, size);
    error[f] =
      NextUp(error[f] + Gamma(degree[static_cast<std::size_t>(direction)] + 1) * LargestOf(part));
    pixelexact::Halve(degree, direction, part, std::span(upper.values).subspan(f * size, size));
  }
  upper.error = error;
  upper.base = base;
  return upper;
}
} // namespace pixelexact
