// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace pixelexact
{
/// The xi of the points (eta[i], eta[j], eta[k]), k fastest.
inline std::vector<Vec3> TensorLattice(Shape shape, std::span<const double> eta)
{
  std::vector<Vec3> xi;
  xi.reserve(eta.size() * eta.size() * eta.size());
  for (const double a : eta)
  {
    for (const double b : eta)
    {
      for (const double c : eta)
      {
        xi.push_back(TensorToReference(shape, { a, b, c }));
      }
    }
  }
  return xi;
}

/// The i-th of Chebyshev's n points.
inline double ChebyshevPoint(int i, int n)
{
  return std::cos(std::numbers::pi * (2 * i + 1) / (2 * n));
}
} // namespace pixelexact
