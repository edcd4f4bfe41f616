// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tree/BoxCoefficients.h"

#include "Core/Bernstein/SweepKernels.h"
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
  const NumberExtremes extremes = ExtremesOf(values);
  return extremes.finite ? std::max(-extremes.least, extremes.most)
                         : std::numeric_limits<double>::infinity();
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
  const NumberExtremes extremes = ExtremesOf(Of(function));
  return extremes.finite && error[function] < std::numeric_limits<double>::infinity()
    ? rounding::Outward(extremes.least - error[function], extremes.most + error[function])
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
    Subtract(shift, part);
    base[f] = moved;
    error[f] = NextUp(error[f] + Gamma(1) * LargestOf(part));
  }
}

BoxCoefficients BoxCoefficients::Subdivide(const std::array<int, 3>& degree, int direction)
{
  for (std::size_t f = 0; f < error.size(); ++f)
  {
    error[f] =
      NextUp(error[f] + Gamma(degree[static_cast<std::size_t>(direction)] + 1) * LargestOf(Of(f)));
  }
  BoxCoefficients upper;
  upper.values.resize(values.size());
  pixelexact::Subdivide(degree, direction, values, upper.values);
  upper.error = error;
  upper.base = base;
  return upper;
}
} // namespace pixelexact
