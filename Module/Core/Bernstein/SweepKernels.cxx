// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Bernstein/SweepKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Lanes-inl.h"

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

/// b[i] = (1 - t) b[i] + t b[i + stride] for `count` numbers.
HWY_INLINE void SweepFromBelow(double t, std::size_t stride, double* b, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const double s = 1.0 - t;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    Store(Traits::Splat(s) * Traits::Load(b + i) + Traits::Splat(t) * Traits::Load(b + i + stride),
      b + i);
  }
  for (; i < count; ++i)
  {
    b[i] = s * b[i] + t * b[i + stride];
  }
}

/// b[i + stride] = (1 - t) b[i] + t b[i + stride] for `count` numbers, from the end on.
HWY_INLINE void SweepFromAbove(double t, std::size_t stride, double* b, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const double s = 1.0 - t;
  std::size_t i = count;
  for (; i >= lanes; i -= lanes)
  {
    double* const at = b + i - lanes;
    Store(Traits::Splat(s) * Traits::Load(at) + Traits::Splat(t) * Traits::Load(at + stride),
      at + stride);
  }
  while (i-- > 0)
  {
    b[i + stride] = s * b[i] + t * b[i + stride];
  }
}

void RestrictAll(
  int degree, std::size_t stride, double from, double rest, double* b, std::size_t size)
{
  const auto n = static_cast<std::size_t>(degree);
  for (std::size_t start = 0; start < size; start += stride * (n + 1))
  {
    for (std::size_t level = 1; from > 0.0 && level <= n; ++level)
    {
      SweepFromBelow(from, stride, b + start, (n + 1 - level) * stride);
    }
    for (std::size_t level = 1; rest < 1.0 && level <= n; ++level)
    {
      SweepFromAbove(rest, stride, b + start + (level - 1) * stride, (n + 1 - level) * stride);
    }
  }
}

void AddOuterTo(
  const double* factors, std::size_t count, const double* from, std::size_t width, double* to)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  for (std::size_t j = 0; j < count; ++j, to += width)
  {
    const double factor = factors[j];
    const Lanes scale = Traits::Splat(factor);
    std::size_t i = 0;
    for (; i + lanes <= width; i += lanes)
    {
      Store(Traits::Load(to + i) + scale * Traits::Load(from + i), to + i);
    }
    for (; i < width; ++i)
    {
      to[i] += factor * from[i];
    }
  }
}

void CombineRows(const double* factors, const double* const* rows, std::size_t count,
  std::size_t width, double* to)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  std::size_t i = 0;
  for (; i + lanes <= width; i += lanes)
  {
    Lanes sum = Traits::Splat(0.0);
    for (std::size_t r = 0; r < count; ++r)
    {
      sum = sum + Traits::Splat(factors[r]) * Traits::Load(rows[r] + i);
    }
    Store(sum, to + i);
  }
  for (; i < width; ++i)
  {
    to[i] = 0.0;
    for (std::size_t r = 0; r < count; ++r)
    {
      to[i] += factors[r] * rows[r][i];
    }
  }
}

Extremes FindExtremes(const double* values, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes zero = Traits::Splat(0.0);
  Extremes found{ values[0], values[0], true };
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
  // Comparisons with what is no number are false.
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
  [[nodiscard]] HWY_INLINE Extremes Found() const
  {
    const Lanes zero = Traits::Splat(0.0);
    return { Least(least), Most(most), All(And(none <= zero, none >= zero)) };
  }
};

Extremes FindDifferences(
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
    const Extremes found = range.Found();
    none += found.finite ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    least[slice] = found.least < low ? found.least : low;
    most[slice] = found.most > high ? found.most : high;
  }
  return none == 0.0;
}

/// In eight sums, however many lanes there are.
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

void SubtractFrom(double shift, double* values, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes by = Traits::Splat(shift);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    Store(Traits::Load(values + i) - by, values + i);
  }
  for (; i < count; ++i)
  {
    values[i] -= shift;
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
namespace
{
std::size_t StrideAlong(const std::array<int, 3>& degree, int direction)
{
  std::size_t stride = 1;
  for (int d = 2; d > direction; --d)
  {
    stride *= static_cast<std::size_t>(degree[static_cast<std::size_t>(d)] + 1);
  }
  return stride;
}
} // namespace

HWY_EXPORT(AddOuterTo);
HWY_EXPORT(CombineRows);
HWY_EXPORT(FindDifferences);
HWY_EXPORT(FindExtremes);
HWY_EXPORT(FindExtremesAlong);
HWY_EXPORT(FindLargestDifference);
HWY_EXPORT(RestrictAll);
HWY_EXPORT(SubtractFrom);
HWY_EXPORT(SumOfMagnitudes);

void SweepTo(const std::array<int, 3>& degree, int direction, double from, double rest,
  std::span<double> bernstein)
{
  HWY_DYNAMIC_DISPATCH(RestrictAll)
  (degree[static_cast<std::size_t>(direction)], StrideAlong(degree, direction), from, rest,
    bernstein.data(), bernstein.size());
}

Extremes ExtremesOf(std::span<const double> values)
{
  return HWY_DYNAMIC_DISPATCH(FindExtremes)(values.data(), values.size());
}

Extremes DifferencesOf(std::span<const double> values, std::size_t stride, std::size_t block)
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

void Subtract(double shift, std::span<double> values)
{
  HWY_DYNAMIC_DISPATCH(SubtractFrom)(shift, values.data(), values.size());
}

void AddOuter(std::span<const double> factors, std::span<const double> from, double* to)
{
  HWY_DYNAMIC_DISPATCH(AddOuterTo)(factors.data(), factors.size(), from.data(), from.size(), to);
}

void Combine(std::span<const double> factors, const double* const* rows, std::span<double> to)
{
  HWY_DYNAMIC_DISPATCH(CombineRows)
  (factors.data(), rows, factors.size(), to.size(), to.data());
}
} // namespace pixelexact
#endif
