// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace pixelexact
{
/// Splits tensor-product Bernstein coefficients of the given degree at the middle of direction d
/// (de Casteljau): `bernstein` becomes the lower half's, `upper` the upper half's. Rounding adds at
/// most gamma(degree[d]) max |b|. Several functions may lie one after the other. The same bits on
/// each instruction set.
void Subdivide(const std::array<int, 3>& degree, int direction, std::span<double> bernstein,
  std::span<double> upper);
} // namespace pixelexact
