// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Bernstein/ExtremeKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Lanes-inl.h"

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

NumberExtremes FindExtremes(const double* values, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes zero = Traits::Splat(0.0);
  NumberExtremes found{ values[0], values[0], true };
  Lanes least = Traits::Splat(values[0]);
  Lanes most = least;
  Lanes none = zero; // not zero where something is not finite
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    const Lanes v = Traits::Load(values + i);
    least = Min(least, v);
    most = Max(most, v);
    none = none + (v - v);
  }
  for (; i < count; ++i)
  {
    found.least = values[i] < found.least ? values[i] : found.least;
    found.most = values[i] > found.most ? values[i] : found.most;
    none = none + Traits::Splat(values[i] - values[i]);
  }
  const double first = Least(least);
  const double last = Most(most);
  return { first < found.least ? first : found.least, last > found.most ? last : found.most,
    All(And(none <= zero, none >= zero)) };
}

double FindLargestDifference(
  const double* values, std::size_t size, std::size_t stride, std::size_t block, int order)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const std::size_t count = block - static_cast<std::size_t>(order) * stride;
  // Comparisons with NaN are false.
  Lanes most = Traits::Splat(0.0);
  double left = 0.0;
  const auto visit = [&](const double* b) PIXELEXACT_INLINED
  {
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
    {
      const Lanes middle = Traits::Load(b + i + stride);
      Lanes step = middle - Traits::Load(b + i);
      if (order == 2)
      {
        step = (Traits::Load(b + i + 2 * stride) - middle) - step;
      }
      most = Select(most < Abs(step), Abs(step), most);
    }
    for (; i < count; ++i)
    {
      const double step = b[i + stride] - b[i];
      const double size1 = std::fabs(order == 2 ? b[i + 2 * stride] - b[i + stride] - step : step);
      left = left < size1 ? size1 : left;
    }
  };
  for (std::size_t start = 0; start < size; start += block)
  {
    visit(values + start);
  }
  const double last = Most(most);
  return last > left ? last : left;
}

/// The least and the most of packs and of single numbers, and whether all are finite.
struct Range
{
  Lanes least;
  Lanes most;
  Lanes none; ///< not zero where something is not finite

  HWY_INLINE Range()
    : least(Traits::Splat(std::numeric_limits<double>::infinity()))
    , most(Traits::Splat(-std::numeric_limits<double>::infinity()))
    , none(Traits::Splat(0.0))
  {
  }

  HWY_INLINE void Add(Lanes v)
  {
    least = Min(least, v);
    most = Max(most, v);
    none = none + (v - v);
  }
  [[nodiscard]] HWY_INLINE NumberExtremes Found() const
  {
    const Lanes zero = Traits::Splat(0.0);
    return { Least(least), Most(most), All(And(none <= zero, none >= zero)) };
  }
};

NumberExtremes FindDifferences(
  const double* values, std::size_t size, std::size_t stride, std::size_t block)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  Range range;
  for (std::size_t start = 0; start < size; start += block)
  {
    const double* const b = values + start;
    std::size_t i = 0;
    for (; i + lanes <= block - stride; i += lanes)
    {
      range.Add(Traits::Load(b + i + stride) - Traits::Load(b + i));
    }
    for (; i < block - stride; ++i)
    {
      range.Add(Traits::Splat(b[i + stride] - b[i]));
    }
  }
  return range.Found();
}

bool FindExtremesAlong(const double* values, std::size_t size, std::size_t stride,
  std::size_t block, double* least, double* most)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  double none = 0.0; // not zero where something is not finite
  for (std::size_t slice = 0; slice * stride < block; ++slice)
  {
    Range range;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t start = slice * stride; start < size; start += block)
    {
      const double* const b = values + start;
      std::size_t i = 0;
      for (; i + lanes <= stride; i += lanes)
      {
        range.Add(Traits::Load(b + i));
      }
      for (; i < stride; ++i)
      {
        low = b[i] < low ? b[i] : low;
        high = b[i] > high ? b[i] : high;
        none += b[i] - b[i];
      }
    }
    const NumberExtremes found = range.Found();
    none += found.finite ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    least[slice] = found.least < low ? found.least : low;
    most[slice] = found.most > high ? found.most : high;
  }
  return none == 0.0;
}

/// Uses eight sums for any number of lanes, so that the bits are the same.
double SumOfMagnitudes(const double* values, const double* weights, std::size_t count)
{
  constexpr std::size_t kSums = 8;
  const auto lanes = static_cast<std::size_t>(LaneCount());
  double sums[kSums] = {};
  std::size_t i = 0;
  for (; i + kSums <= count; i += kSums)
  {
    for (std::size_t k = 0; k < kSums; k += lanes)
    {
      Store(
        Traits::Load(sums + k) + Abs(Traits::Load(values + i + k)) * Traits::Load(weights + i + k),
        sums + k);
    }
  }
  for (std::size_t k = 0; i < count; ++i, ++k)
  {
    sums[k] += std::fabs(values[i]) * weights[i];
  }
  double all = 0.0;
  for (const double sum : sums)
  {
    all += sum;
  }
  return all;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FindDifferences);
HWY_EXPORT(FindExtremes);
HWY_EXPORT(FindExtremesAlong);
HWY_EXPORT(FindLargestDifference);
HWY_EXPORT(SumOfMagnitudes);

NumberExtremes ExtremesOf(std::span<const double> values)
{
  return HWY_DYNAMIC_DISPATCH(FindExtremes)(values.data(), values.size());
}

NumberExtremes DifferencesOf(std::span<const double> values, std::size_t stride, std::size_t block)
{
  return HWY_DYNAMIC_DISPATCH(FindDifferences)(values.data(), values.size(), stride, block);
}

bool ExtremesAlong(std::span<const double> values, std::size_t stride, std::size_t block,
  std::span<double> least, std::span<double> most)
{
  return HWY_DYNAMIC_DISPATCH(FindExtremesAlong)(
    values.data(), values.size(), stride, block, least.data(), most.data());
}

double LargestDifference(
  std::span<const double> values, std::size_t stride, std::size_t block, int order)
{
  return HWY_DYNAMIC_DISPATCH(FindLargestDifference)(
    values.data(), values.size(), stride, block, order);
}

double WeighMagnitudes(std::span<const double> values, const double* weights)
{
  return HWY_DYNAMIC_DISPATCH(SumOfMagnitudes)(values.data(), weights, values.size());
}
} // namespace pixelexact
#endif
