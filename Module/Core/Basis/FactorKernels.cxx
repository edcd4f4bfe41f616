// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Basis/FactorKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Basis/FactorKernels.h"
#include "Core/Math/Pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
void MultiplyIn(const PairMatrix& matrix, std::size_t rest, const double* high, const double* low,
  double* toHigh, double* toLow)
{
  using Traits = NumberTraits<Lanes>;
  const auto rows = static_cast<std::size_t>(matrix.rows);
  const auto columns = static_cast<std::size_t>(matrix.columns);
  const auto lanes = static_cast<std::size_t>(LaneCount());
  for (std::size_t r = 0; r < rest; ++r)
  {
    for (std::size_t row = 0; row < rows; row += lanes)
    {
      Lanes sum = Traits::Splat(0.0);
      Lanes rounding = sum;
      for (std::size_t k = 0; k < columns; ++k)
      {
        const std::size_t at = k * matrix.stride + row;
        const Lanes factor = Traits::Load(&matrix.high[at]);
        const Lanes value = Traits::Splat(high[k * rest + r]);
        const Pair product = ExactProduct(factor, value);
        const Pair next = ExactSum(sum, product.high);
        sum = next.high;
        rounding = rounding + (product.low + next.low);
        rounding = rounding + factor * Traits::Splat(low[k * rest + r]);
        rounding = rounding + Traits::Load(&matrix.low[at]) * value;
      }
      // The next pack overwrites the entries that this one writes past its end.
      const Pair result = ExactSum(sum, rounding);
      Store(result.high, toHigh + r * rows + row);
      Store(result.low, toLow + r * rows + row);
    }
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(MultiplyIn);

namespace
{
/// The largest number of lanes of any instruction set.
constexpr std::size_t kPack = 8;
} // namespace

PairMatrix::PairMatrix(const BasisFactor& factor)
  : rows(factor.rows)
  , columns(factor.columns)
  , stride((static_cast<std::size_t>(factor.rows) + kPack - 1) / kPack * kPack)
  , high(stride * static_cast<std::size_t>(factor.columns))
  , low(high.size())
{
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const long double m = factor.matrix[static_cast<std::size_t>(row) * columns + column];
      const std::size_t at = static_cast<std::size_t>(column) * stride + row;
      high[at] = static_cast<double>(m);
      low[at] = static_cast<double>(m - high[at]);
    }
  }
}

void PairBuffer::Resize(std::size_t size)
{
  high.resize(size + kPack);
  low.resize(size + kPack);
}

void Multiply(const PairMatrix& matrix, std::size_t rest, const PairBuffer& from, PairBuffer& to)
{
  to.Resize(rest * static_cast<std::size_t>(matrix.rows));
  HWY_DYNAMIC_DISPATCH(MultiplyIn)
  (matrix, rest, from.high.data(), from.low.data(), to.high.data(), to.low.data());
}
} // namespace pixelexact
#endif
