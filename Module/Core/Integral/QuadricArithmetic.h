// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CutFunction.h"
#include "Core/Integral/ChebyshevModel.h"

#include <array>
#include <cstddef>

namespace pixelexact
{
/// A number that is exact, times one of an arithmetic with bounds.
inline Interval Scaled(double a, const Interval& b)
{
  return Interval(a) * b;
}
inline ChebyshevModel Scaled(double a, const ChebyshevModel& b)
{
  return a * b;
}

/// The gradient of a quadric's function at z, numbers of any kind.
template <class Number>
std::array<Number, 3> GradientOf(const QuadricForm& form, const std::array<Number, 3>& z)
{
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
    { 0, 1 }, { 1, 2 }, { 0, 2 } } };
  std::array<Number, 3> gradient{ form.g.x, form.g.y, form.g.z };
  for (std::size_t k = 0; k < kPairs.size(); ++k)
  {
    const auto [a, b] = kPairs[k];
    if (form.q[k] != 0.0)
    {
      gradient[a] = gradient[a] + Scaled(form.q[k], z[b]);
      gradient[b] = gradient[b] + Scaled(form.q[k], z[a]);
    }
  }
  return gradient;
}
} // namespace pixelexact
