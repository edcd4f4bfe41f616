// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LongModes.h"
#include "MeshBuilder.h"

#include <array>

namespace pixelexact::testing
{
/// Phi of the stored coefficients in long double (64 bits of mantissa): 2,000 times finer than what
/// is tested with it. Right beyond the shape too, where a point may lie by its face's tolerance.
class LongMap
{
public:
  explicit LongMap(const Mesh& mesh)
    : Elements(mesh)
  {
  }

  [[nodiscard]] LongVec3 operator()(int element, const LongVec3& xi)
  {
    const std::vector<long double>& modes = Modes(Elements.map.SpaceOf(element), xi);
    const double* coefficient = Elements.map.Coefficients(element);
    LongVec3 x{};
    for (int d = 0; d < 3; ++d)
    {
      for (const long double mode : modes)
      {
        x[d] += *coefficient++ * mode;
      }
      x[d] = Elements.centre[3 * static_cast<std::size_t>(element) + d] +
        x[d] * static_cast<long double>(Elements.size[element]);
    }
    return x;
  }

  /// The columns dPhi / dxi_j in world units, where Phi is `at` that: to some 1e-8, by differences.
  [[nodiscard]] std::array<LongVec3, 3> Columns(int element, const LongVec3& xi, const LongVec3& at)
  {
    // Small against the distance to a pyramid's apex, where the functions are rational.
    constexpr long double kStep = 0x1p-34L;
    std::array<LongVec3, 3> columns;
    for (int j = 0; j < 3; ++j)
    {
      LongVec3 next = xi;
      next[j] += kStep;
      columns[j] = Times(1.0L / kStep, Minus((*this)(element, next), at));
    }
    return columns;
  }

private:
  Mesh Elements;
  LongModes<long double> Modes;
};
} // namespace pixelexact::testing
