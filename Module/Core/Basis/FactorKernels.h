// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"

#include <cstddef>
#include <vector>

// Products with the factors of a ChangeOfBasis in lanes. Numbers are unevaluated sums of two
// doubles, high and low, of some 106 bits: no less than long double has, at a fifth of its time.
namespace pixelexact
{
/// A factor's matrix, column by column; columns are padded with zeros to whole packs of lanes.
struct PairMatrix
{
  explicit PairMatrix(const BasisFactor& factor);

  int rows = 0;
  int columns = 0;
  std::size_t stride = 0; ///< from one column to the next
  std::vector<double> high;
  std::vector<double> low;
};

/// Numbers that are room for a product; behind the last there is a pack more.
struct PairBuffer
{
  void Resize(std::size_t size);

  std::vector<double> high;
  std::vector<double> low;
};

/// to[r * rows + i] = sum over k of M[i][k] from[k * rest + r]. Off by at most
/// 2^-100 sum |M[i][k] from[k * rest + r]| for up to 2,000 columns, where nothing over- or
/// underflows (T. Ogita, S. Rump and S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput.
/// 26, 2005, Dot2, with low parts); infinities become NaN. The same bits on every machine but for
/// such.
void Multiply(const PairMatrix& matrix, std::size_t rest, const PairBuffer& from, PairBuffer& to);
} // namespace pixelexact
