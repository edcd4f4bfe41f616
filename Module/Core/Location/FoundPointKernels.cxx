// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/FoundPointKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Location/PointKernels.h"
#include "Core/Math/Lanes-inl.h"

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Finds the points inside among a pack from `at` on, of which the first `count` exist.
HWY_INLINE std::uint64_t InsideFrom(const double* status, int at, int count)
{
  using Traits = NumberTraits<Lanes>;
  const Lanes wanted = Traits::Splat(static_cast<double>(NewtonStatus::RootInside));
  const Lanes is = Traits::Load(status + at);
  const std::uint64_t there =
    ~std::uint64_t{ 0 } >> static_cast<unsigned>(64 - std::min(count, LaneCount()));
  return BitsOf(And(is <= wanted, is >= wanted)) & there;
}

int FindAllOthers(const double* status, int count, int* others)
{
  const int lanes = LaneCount();
  int found = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const int there = std::min(lanes, count - i);
    const std::uint64_t all = ~std::uint64_t{ 0 } >> static_cast<unsigned>(64 - there);
    for (std::uint64_t left = all & ~InsideFrom(status, i, there); left != 0; left &= left - 1)
    {
      others[found++] = i + std::countr_zero(left);
    }
  }
  return found;
}

int KeepAllInside(const InverseResult& result, int count, int* numbers)
{
  const int lanes = LaneCount();
  // Local copies, so that the compiler need not assume that a store changes them.
  const double* const status = result.status;
  const std::array<double*, 4> arrays{ result.xi[0], result.xi[1], result.xi[2], result.residual };
  const std::uint64_t whole = ~std::uint64_t{ 0 } >> static_cast<unsigned>(64 - lanes);
  int kept = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const std::uint64_t inside = InsideFrom(status, i, count - i);
    // All or none of a pack are usually inside.
    if (inside == 0)
    {
      continue;
    }
    if (inside == whole)
    {
      for (std::size_t k = 0; kept < i && k < arrays.size(); ++k)
      {
        Store(NumberTraits<Lanes>::Load(arrays[k] + i), arrays[k] + kept);
      }
      std::copy_n(numbers + i, kept < i ? lanes : 0, numbers + kept);
      kept += lanes;
      continue;
    }
    const LanesToFront front(inside);
    // Writes no farther than has been read.
    for (double* const array : arrays)
    {
      Store(front(NumberTraits<Lanes>::Load(array + i)), array + kept);
    }
    for (std::uint64_t left = inside; left != 0; left &= left - 1)
    {
      numbers[kept++] = numbers[i + std::countr_zero(left)];
    }
  }
  for (double* const array : arrays)
  {
    std::fill(array + kept, array + PaddedCount(kept), kept > 0 ? array[kept - 1] : 0.0);
  }
  return kept;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FindAllOthers);
HWY_EXPORT(KeepAllInside);

int FindOthers(const double* status, int count, int* others)
{
  return HWY_DYNAMIC_DISPATCH(FindAllOthers)(status, count, others);
}

int KeepInside(const InverseResult& result, int count, int* numbers)
{
  return HWY_DYNAMIC_DISPATCH(KeepAllInside)(result, count, numbers);
}
} // namespace pixelexact
#endif
