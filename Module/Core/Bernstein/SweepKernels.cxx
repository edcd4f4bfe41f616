// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Bernstein/SweepKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Lanes-inl.h"

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
HWY_EXPORT(RestrictAll);
HWY_EXPORT(SubtractFrom);

void SweepTo(const std::array<int, 3>& degree, int direction, double from, double rest,
  std::span<double> bernstein)
{
  HWY_DYNAMIC_DISPATCH(RestrictAll)
  (degree[static_cast<std::size_t>(direction)], StrideAlong(degree, direction), from, rest,
    bernstein.data(), bernstein.size());
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
