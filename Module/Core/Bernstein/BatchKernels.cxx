// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Bernstein/BatchKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Bernstein/BatchKernels.h"
#include "Core/Math/Lanes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

/// Calls atLanes(i) for packs that cover 0 <= i < count, the last of which may overlap the one
/// before, or atOne(i) for each, where there are too few.
template <class AtLanes, class AtOne>
HWY_INLINE void ForEachPack(std::size_t count, const AtLanes& atLanes, const AtOne& atOne)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  if (count < lanes)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      atOne(i);
    }
    return;
  }
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    atLanes(i);
  }
  if (i < count)
  {
    atLanes(count - lanes);
  }
}

/// Rows of a block's combinations that share their loads.
constexpr std::size_t kRowsAtOnce = 4;

/// Combines the rows for four rows of factors, at one pack.
HWY_INLINE void CombineFour(
  const double* factors, std::size_t count, const double* rows, std::size_t stride, double* out)
{
  // Separate variables, because compilers leave an array in memory.
  const double* const f1 = factors + count;
  const double* const f2 = f1 + count;
  const double* const f3 = f2 + count;
  const Lanes first = Traits::Load(rows);
  Lanes a = Traits::Splat(factors[0]) * first;
  Lanes b = Traits::Splat(f1[0]) * first;
  Lanes c = Traits::Splat(f2[0]) * first;
  Lanes d = Traits::Splat(f3[0]) * first;
  for (std::size_t j = 1; j < count; ++j)
  {
    const Lanes row = Traits::Load(rows + j * stride);
    a = a + Traits::Splat(factors[j]) * row;
    b = b + Traits::Splat(f1[j]) * row;
    c = c + Traits::Splat(f2[j]) * row;
    d = d + Traits::Splat(f3[j]) * row;
  }
  Store(a, out);
  Store(b, out + stride);
  Store(c, out + 2 * stride);
  Store(d, out + 3 * stride);
}

void CombineBlocks(const double* factors, std::size_t made, std::size_t count, std::size_t stride,
  const double* from, std::size_t size, double* to)
{
  for (const double* rows = from; rows < from + size; rows += count * stride)
  {
    double* const out = to + static_cast<std::size_t>(rows - from) / count * made;
    ForEachPack(
      stride,
      [&](std::size_t i) PIXELEXACT_INLINED
      {
        std::size_t k = 0;
        for (; k + kRowsAtOnce <= made; k += kRowsAtOnce)
        {
          CombineFour(factors + k * count, count, rows + i, stride, out + k * stride + i);
        }
        for (; k < made; ++k)
        {
          const double* const factor = factors + k * count;
          Lanes sum = Traits::Splat(factor[0]) * Traits::Load(rows + i);
          for (std::size_t j = 1; j < count; ++j)
          {
            sum = sum + Traits::Splat(factor[j]) * Traits::Load(rows + j * stride + i);
          }
          Store(sum, out + k * stride + i);
        }
      },
      [&](std::size_t i) PIXELEXACT_INLINED
      {
        for (std::size_t k = 0; k < made; ++k)
        {
          const double* const factor = factors + k * count;
          double sum = factor[0] * rows[i];
          for (std::size_t j = 1; j < count; ++j)
          {
            sum += factor[j] * rows[j * stride + i];
          }
          out[k * stride + i] = sum;
        }
      });
  }
}

void FindEach(
  const double* values, std::size_t size, std::size_t count, double* least, double* most)
{
  ForEachPack(
    count,
    [&](std::size_t i) PIXELEXACT_INLINED
    {
      Lanes low = Traits::Load(values + i);
      Lanes high = low;
      for (std::size_t at = count; at < size; at += count)
      {
        const Lanes v = Traits::Load(values + at + i);
        low = Min(low, v);
        high = Max(high, v);
      }
      Store(low, least + i);
      Store(high, most + i);
    },
    [&](std::size_t i) PIXELEXACT_INLINED
    {
      least[i] = most[i] = values[i];
      for (std::size_t at = count; at < size; at += count)
      {
        least[i] = std::min(least[i], values[at + i]);
        most[i] = std::max(most[i], values[at + i]);
      }
    });
}

void FindBeside(const double* values, std::size_t stride, std::span<const Vec3> places,
  const double* const* slopes, std::size_t count, double* least, double* most)
{
  ForEachPack(
    count,
    [&](std::size_t i) PIXELEXACT_INLINED
    {
      const Lanes slope[3] = { Traits::Load(slopes[0] + i), Traits::Load(slopes[1] + i),
        Traits::Load(slopes[2] + i) };
      Lanes low = Traits::Splat(0.0);
      Lanes high = low;
      for (std::size_t r = 0; r < places.size(); ++r)
      {
        const Vec3& x = places[r];
        const Lanes affine = slope[0] * Traits::Splat(x.x) + slope[1] * Traits::Splat(x.y) +
          slope[2] * Traits::Splat(x.z);
        const Lanes left = Traits::Load(values + r * stride + i) - affine;
        low = r == 0 ? left : Min(low, left);
        high = r == 0 ? left : Max(high, left);
      }
      Store(low, least + i);
      Store(high, most + i);
    },
    [&](std::size_t i) PIXELEXACT_INLINED
    {
      for (std::size_t r = 0; r < places.size(); ++r)
      {
        const Vec3& x = places[r];
        const double left =
          values[r * stride + i] - (slopes[0][i] * x.x + slopes[1][i] * x.y + slopes[2][i] * x.z);
        least[i] = r == 0 ? left : std::min(least[i], left);
        most[i] = r == 0 ? left : std::max(most[i], left);
      }
    });
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(CombineBlocks);
HWY_EXPORT(FindEach);
HWY_EXPORT(FindBeside);

void CombineRows(std::span<const double> factors, std::size_t made, std::size_t count,
  std::size_t stride, std::span<const double> from, std::span<double> to)
{
  HWY_DYNAMIC_DISPATCH(CombineBlocks)
  (factors.data(), made, count, stride, from.data(), from.size(), to.data());
}

void ExtremesOfEach(std::span<const double> values, std::span<double> least, std::span<double> most)
{
  HWY_DYNAMIC_DISPATCH(FindEach)
  (values.data(), values.size(), least.size(), least.data(), most.data());
}

void ExtremesBesideAffine(std::span<const double> values, std::size_t stride,
  std::span<const Vec3> places, const std::array<std::vector<double>, 3>& slopes,
  std::span<double> least, std::span<double> most)
{
  const double* const rows[3] = { slopes[0].data(), slopes[1].data(), slopes[2].data() };
  HWY_DYNAMIC_DISPATCH(FindBeside)
  (values.data(), stride, places, rows, least.size(), least.data(), most.data());
}
} // namespace pixelexact
#endif
