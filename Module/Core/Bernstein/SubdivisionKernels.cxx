// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Bernstein/SubdivisionKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Bernstein/SweepKernels.h"
#include "Core/Math/Lanes-inl.h"

#include <algorithm>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

/// b = (a + b) / 2 for `count` numbers; a and b may overlap where b comes after a.
HWY_INLINE void Average(const double* a, double* b, std::size_t count)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes half = Traits::Splat(0.5);
  // Runs from the end, so that no number is written before it is read.
  std::size_t i = count;
  for (; i >= lanes; i -= lanes)
  {
    Store(half * (Traits::Load(a + i - lanes) + Traits::Load(b + i - lanes)), b + i - lanes);
  }
  while (i-- > 0)
  {
    b[i] = 0.5 * (a[i] + b[i]);
  }
}

/// One line or sheet of coefficients: n + 1 rows of `stride` numbers, subdivided in place.
HWY_INLINE void SubdivideInPlace(std::size_t n, std::size_t stride, double* b, double* u)
{
  const auto copy = [&](std::size_t to) PIXELEXACT_INLINED
  {
    for (std::size_t i = 0; i < stride; ++i)
    {
      u[to * stride + i] = b[n * stride + i];
    }
  };
  // Each sweep leaves one coefficient of each child in place.
  copy(n);
  for (std::size_t level = 1; level <= n; ++level)
  {
    Average(b + (level - 1) * stride, b + level * stride, (n + 1 - level) * stride);
    copy(n - level);
  }
}

/// All sweeps of a pack of lines side by side, from coefficients in `line` to those of the lower
/// child; `upper` receives those of the upper child: n + 1 packs each, `stride` apart. Two sweeps
/// run at once, so that the results of the first stay in registers.
HWY_INLINE void SubdivideLines(std::size_t n, double* line, double* upper, std::size_t stride)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const Lanes half = Traits::Splat(0.5);
  const auto at = [&](std::size_t i) PIXELEXACT_INLINED { return Traits::Load(line + i * lanes); };
  const auto storeUpper = [&](Lanes end, std::size_t i) PIXELEXACT_INLINED
  { Store(end, upper + i * stride); };
  storeUpper(at(n), n);
  std::size_t level = 1;
  for (; level < n; level += 2)
  {
    Lanes below = at(n - 1);
    Lanes once = half * (below + at(n));
    storeUpper(once, n - level);
    for (std::size_t i = n; i > level; --i)
    {
      const Lanes next = at(i - 2);
      const Lanes first = half * (next + below);
      Store(half * (first + once), line + i * lanes);
      below = next;
      once = first;
    }
    Store(once, line + level * lanes);
    storeUpper(at(n), n - level - 1);
  }
  if (level == n)
  {
    Store(half * (at(n - 1) + at(n)), line + n * lanes);
    storeUpper(at(n), 0);
  }
}

/// Buffers of the sweeps: one pack of lines to subdivide, and one that is loaded before it is
/// overwritten.
class LineBuffers
{
public:
  explicit LineBuffers(std::size_t n)
    : Size((n + 1) * static_cast<std::size_t>(LaneCount()))
  {
    if (2 * Size > std::size(Few))
    {
      Many.resize(2 * Size);
    }
  }
  [[nodiscard]] double* First() { return Many.empty() ? Few : Many.data(); }
  [[nodiscard]] double* Second() { return First() + Size; }

private:
  static constexpr std::size_t kFew = std::size_t{ 2 } * 33 * 8;

  std::size_t Size;
  double Few[kFew];
  std::vector<double> Many;
};

/// One sheet of coefficients: n + 1 rows of `stride` numbers, which is no less than a pack.
HWY_INLINE void SubdivideSheet(
  std::size_t n, std::size_t stride, LineBuffers& buffers, double* b, double* u)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const auto load = [&](std::size_t column, double* to) PIXELEXACT_INLINED
  {
    for (std::size_t i = 0; i <= n; ++i)
    {
      Store(Traits::Load(b + i * stride + column), to + i * lanes);
    }
  };
  const auto subdivide = [&](std::size_t column, double* line) PIXELEXACT_INLINED
  {
    SubdivideLines(n, line, u + column, stride);
    for (std::size_t i = 0; i <= n; ++i)
    {
      Store(Traits::Load(line + i * lanes), b + i * stride + column);
    }
  };
  // The last pack overlaps the one before. Its lines are loaded first, so that they are subdivided
  // once.
  const std::size_t last = stride - lanes;
  load(last, buffers.Second());
  for (std::size_t column = 0; column < last; column += lanes)
  {
    load(column, buffers.First());
    subdivide(column, buffers.First());
  }
  subdivide(last, buffers.Second());
}

/// Lines whose coefficients lie next to each other or nearly so, a pack of lines at a time.
HWY_INLINE void SubdivideNarrow(
  std::size_t n, std::size_t stride, LineBuffers& buffers, double* b, double* u, std::size_t size)
{
  const auto lanes = static_cast<std::size_t>(LaneCount());
  const std::size_t count = size / (n + 1);
  double* const line = buffers.First();
  double* const upper = buffers.Second();
  std::size_t begins[8] = {}; // of each lane's line
  std::size_t next = 0;
  std::size_t column = 0;
  for (std::size_t first = 0; first < count; first += lanes)
  {
    // Lanes beyond the last line hold the first of the pack once more.
    const std::size_t used = std::min(lanes, count - first);
    for (std::size_t k = 0; k < used; ++k)
    {
      begins[k] = next++;
      if (++column == stride)
      {
        column = 0;
        next += stride * n;
      }
      for (std::size_t i = 0; i <= n; ++i)
      {
        line[i * lanes + k] = b[begins[k] + i * stride];
      }
    }
    for (std::size_t k = used; k < lanes; ++k)
    {
      for (std::size_t i = 0; i <= n; ++i)
      {
        line[i * lanes + k] = line[i * lanes];
      }
    }
    SubdivideLines(n, line, upper, lanes);
    for (std::size_t k = 0; k < used; ++k)
    {
      for (std::size_t i = 0; i <= n; ++i)
      {
        b[begins[k] + i * stride] = line[i * lanes + k];
        u[begins[k] + i * stride] = upper[i * lanes + k];
      }
    }
  }
}

void SubdivideAll(int degree, std::size_t stride, double* b, double* u, std::size_t size)
{
  // Few sweeps cost less than packing.
  constexpr std::size_t kFew = 7;
  const auto n = static_cast<std::size_t>(degree);
  const std::size_t block = stride * (n + 1);
  if (n <= kFew)
  {
    for (std::size_t start = 0; start < size; start += block)
    {
      SubdivideInPlace(n, stride, b + start, u + start);
    }
    return;
  }
  LineBuffers buffers(n);
  if (stride < static_cast<std::size_t>(LaneCount()))
  {
    SubdivideNarrow(n, stride, buffers, b, u, size);
    return;
  }
  for (std::size_t start = 0; start < size; start += block)
  {
    SubdivideSheet(n, stride, buffers, b + start, u + start);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(SubdivideAll);

void Subdivide(const std::array<int, 3>& degree, int direction, std::span<double> bernstein,
  std::span<double> upper)
{
  std::size_t stride = 1;
  for (int d = 2; d > direction; --d)
  {
    stride *= static_cast<std::size_t>(degree[static_cast<std::size_t>(d)] + 1);
  }
  HWY_DYNAMIC_DISPATCH(SubdivideAll)
  (degree[static_cast<std::size_t>(direction)], stride, bernstein.data(), upper.data(),
    bernstein.size());
}
} // namespace pixelexact
#endif
