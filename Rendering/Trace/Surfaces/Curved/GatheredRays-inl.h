// SPDX-License-Identifier: BSD-3-Clause
// A subset of a bundle's rays in whole packs.
#if defined(PIXELEXACT_GATHERED_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_GATHERED_RAYS_INL_H
#undef PIXELEXACT_GATHERED_RAYS_INL_H
#else
#define PIXELEXACT_GATHERED_RAYS_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/RayBundle.h"

#include <array>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

/// Calls test(i, mask) for each pack of rays of the set. Returns those that passed.
template <class Test>
HWY_INLINE RaySet ForEachPack(const RaySet& rays, Test&& test)
{
  RaySet result;
  for (std::size_t word = 0; word < RaySet::kWords; ++word)
  {
    const std::uint64_t bits = rays.bits[word];
    result.bits[word] = ForEachPackIn(bits,
      [&](int i) PIXELEXACT_INLINED
      { return test(static_cast<int>(64 * word) + i, MaskOf(bits >> static_cast<unsigned>(i))); });
  }
  return result;
}

/// The rays of a set, gathered into contiguous arrays.
class GatheredRays
{
public:
  HWY_INLINE GatheredRays(const RayBundle& bundle, const RaySet& rays)
  {
    const auto lanes = static_cast<unsigned>(LaneCount());
    const std::uint64_t pack = (std::uint64_t{ 1 } << lanes) - 1U;
    for (std::size_t word = 0; word < RaySet::kWords; ++word)
    {
      for (std::uint64_t left = rays.bits[word]; left != 0;)
      {
        const unsigned first = static_cast<unsigned>(std::countr_zero(left)) / lanes * lanes;
        const std::uint64_t here = left >> first & pack;
        left &= ~(pack << first);
        Add(bundle, 64 * word + first, here);
      }
    }
  }
  [[nodiscard]] HWY_INLINE int Count() const { return static_cast<int>(Size); }

  std::array<RayBundle::Numbers, 2> place;
  std::array<RayBundle::Numbers, 2> slope;
  RayBundle::Numbers slack;
  RayBundle::Numbers number;

private:
  HWY_INLINE void Add(const RayBundle& bundle, std::size_t at, std::uint64_t which)
  {
    const LanesToFront toFront(which);
    const auto put = [&](const RayBundle::Numbers& from, RayBundle::Numbers& to) PIXELEXACT_INLINED
    { Store(toFront(Traits::Load(&from[at])), &to[Size]); };
    put(bundle.place[0], place[0]);
    put(bundle.place[1], place[1]);
    put(bundle.slope[0], slope[0]);
    put(bundle.slope[1], slope[1]);
    put(bundle.slack, slack);
    const hwy::HWY_NAMESPACE::RebindToSigned<LaneTag> whole;
    const Lanes numbers{ hwy::HWY_NAMESPACE::ConvertTo(
      LaneTag(), hwy::HWY_NAMESPACE::Iota(whole, static_cast<std::int64_t>(at))) };
    Store(toFront(numbers), &number[Size]);
    Size += static_cast<std::size_t>(std::popcount(which));
  }

  std::size_t Size = 0;
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
