// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace pixelexact
{
/// `components` functions, three at most, and their derivatives by xi at some points, kRoom at
/// most: values[component][point], slopes[3 component + direction][point].
struct PointValues
{
  static constexpr std::size_t kRoom = 16;
  double values[3][kRoom];
  double slopes[9][kRoom];

  PointValues() = default;
  /// The functions are `scale` times those of the modes.
  PointValues(const KernelSet& kernels, const Space& space, const double* modes, int components,
    double scale, std::span<const Vec3> points)
  {
    double at[3][kRoom];
    for (std::size_t i = 0; i < kRoom; ++i)
    {
      const Vec3& xi = points[std::min(i, points.size() - 1)];
      for (int d = 0; d < 3; ++d)
      {
        at[d][i] = xi[d];
      }
    }
    double* const out[3] = { values[0], values[1], values[2] };
    double* gradient[9];
    for (std::size_t k = 0; k < 9; ++k)
    {
      gradient[k] = slopes[k];
    }
    kernels.gradient(space, modes, components,
      { { at[0], at[1], at[2] }, static_cast<int>(points.size()) }, out, gradient);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
      {
        values[c][i] *= scale;
        for (std::size_t k = 3 * c; k < 3 * c + 3; ++k)
        {
          slopes[k][i] *= scale;
        }
      }
    }
  }

  [[nodiscard]] Vec3 SlopeOf(std::size_t component, std::size_t point) const
  {
    return { slopes[3 * component][point], slopes[3 * component + 1][point],
      slopes[3 * component + 2][point] };
  }
};
} // namespace pixelexact
