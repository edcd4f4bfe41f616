// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Tree/FrameKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Tree/FrameKernels.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The product is not fused, so that every instruction set has the same bits.
HWY_INLINE Lanes Dot(const double* a, const Point<Lanes>& x)
{
  return Splat(a[0]) * x.x[0] + Splat(a[1]) * x.x[1] + Splat(a[2]) * x.x[2];
}

HWY_INLINE Point<Lanes> LoadPhi(const FrameTask& task, std::size_t at)
{
  Point<Lanes> phi;
  for (int c = 0; c < 3; ++c)
  {
    phi.x[c] = NumberTraits<Lanes>::Load(task.phi[c] + at) - Splat(task.shift[c]);
  }
  return phi;
}

/// Whether the normals are those of a cube's ends: then the extremes along them are known.
template <bool kCube>
FrameSums MeasureEnds(const FrameTask& task)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const FrameTask t = task; // that no store can change
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  const Lanes minusInfinity = Splat(-std::numeric_limits<double>::infinity());
  Lanes least[3] = { infinity, infinity, infinity };
  Lanes most[3] = { minusInfinity, minusInfinity, minusInfinity };
  Lanes lower[3] = { infinity, infinity, infinity };
  Lanes upper[3] = { minusInfinity, minusInfinity, minusInfinity };
  Lanes outer[6];
  Lanes inner[6];
  std::fill_n(outer, 6, minusInfinity);
  std::fill_n(inner, 6, infinity);
  Lanes all = Splat(0.0);
  for (std::size_t next = 0; next < t.size; next += lanes)
  {
    // The last pack overlaps the one before.
    const std::size_t at = std::min(next, t.size - lanes);
    const Point<Lanes> phi = LoadPhi(t, at);
    Point<Lanes> image;
    Point<Lanes> deviation;
    for (int d = 0; d < 3; ++d)
    {
      image.x[d] = Dot(t.inverse + static_cast<std::ptrdiff_t>(3 * d), phi);
      deviation.x[d] = image.x[d] - NumberTraits<Lanes>::Load(t.grid[d] + at);
      least[d] = Min(least[d], deviation.x[d]);
      most[d] = Max(most[d], deviation.x[d]);
      Store(deviation.x[d], t.deviation[d] + at);
      all = all + Abs(deviation.x[d]);
      if (kCube)
      {
        lower[d] = Min(lower[d], image.x[d]);
        upper[d] = Max(upper[d], image.x[d]);
      }
    }
    for (int k = 0; !kCube && k < 6; ++k)
    {
      outer[k] = Max(outer[k], Dot(t.normal[k], image));
      inner[k] = Min(inner[k], Dot(t.normal[k], deviation));
    }
  }
  FrameSums sums;
  for (int d = 0; d < 3; ++d)
  {
    sums.least[d] = Least(least[d]);
    sums.most[d] = Most(most[d]);
    if (kCube)
    {
      sums.outer[2 * d] = -Least(lower[d]);
      sums.outer[2 * d + 1] = Most(upper[d]);
      sums.inner[2 * d] = -sums.most[d];
      sums.inner[2 * d + 1] = sums.least[d];
    }
  }
  for (int k = 0; !kCube && k < 6; ++k)
  {
    sums.outer[k] = Most(outer[k]);
    sums.inner[k] = Least(inner[k]);
  }
  sums.all = All(IsFinite(all)) ? 0.0 : std::numeric_limits<double>::infinity();
  return sums;
}

FrameSums Measure(const FrameTask& task)
{
  return task.normal == nullptr ? MeasureEnds<true>(task) : MeasureEnds<false>(task);
}

void FindOutermost(const FrameTask& task, const double (*normal)[3], double outer[6])
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  Lanes most[6];
  std::fill_n(most, 6, Splat(-std::numeric_limits<double>::infinity()));
  for (std::size_t next = 0; next < task.size; next += lanes)
  {
    const Point<Lanes> phi = LoadPhi(task, std::min(next, task.size - lanes));
    for (int k = 0; k < 6; ++k)
    {
      most[k] = Max(most[k], Dot(normal[k], phi));
    }
  }
  for (int k = 0; k < 6; ++k)
  {
    outer[k] = Most(most[k]);
  }
}

void FillLine(const double from[3], const double step[3], std::size_t count, double* const to[3])
{
  constexpr double kNumbers[8] = { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0 };
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes first = NumberTraits<Lanes>::Load(kNumbers);
  for (int d = 0; d < 3; ++d)
  {
    const auto at = [&](std::size_t k) PIXELEXACT_INLINED
    { return Splat(from[d]) + (Splat(static_cast<double>(k)) + first) * Splat(step[d]); };
    if (count < lanes)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        to[d][k] = from[d] + static_cast<double>(k) * step[d];
      }
      continue;
    }
    for (std::size_t k = 0; k + lanes <= count; k += lanes)
    {
      Store(at(k), to[d] + k);
    }
    Store(at(count - lanes), to[d] + count - lanes);
  }
}

FrameSteps FindSteps(const double* row, std::size_t size, std::size_t count, std::size_t stride)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const std::size_t block = count * stride;
  const std::size_t steps = block - stride;
  if (steps == 0)
  {
    return { 0.0, 0.0 };
  }
  Lanes least = Splat(row[stride] - row[0]);
  Lanes most = least;
  const std::size_t whole = steps / lanes * lanes;
  const LaneMask rest = MaskOf((std::uint64_t{ 1 } << (steps - whole)) - 1U);
  for (std::size_t start = 0; start + block <= size; start += block)
  {
    const double* from = row + start;
    const auto step = [&](std::size_t i) PIXELEXACT_INLINED
    { return NumberTraits<Lanes>::Load(from + i + stride) - NumberTraits<Lanes>::Load(from + i); };
    for (std::size_t i = 0; i < whole; i += lanes)
    {
      least = Min(least, step(i));
      most = Max(most, step(i));
    }
    if (whole < steps)
    {
      const Lanes last = step(whole);
      least = Select(rest, Min(least, last), least);
      most = Select(rest, Max(most, last), most);
    }
  }
  return { Least(least), Most(most) };
}

const FrameKernels& FrameKernelSet()
{
  static constexpr FrameKernels kKernels{ &Measure, &FillLine, &FindOutermost, &FindSteps };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FrameKernelSet);

const FrameKernels& GetFrameKernels()
{
  return HWY_DYNAMIC_DISPATCH(FrameKernelSet)();
}
} // namespace pixelexact
#endif
