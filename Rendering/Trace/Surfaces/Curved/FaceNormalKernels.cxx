// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/FaceNormalKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/FaceNormals.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
void MakeNormals(double sign, const double* const slope[6], int count, double* const to[3])
{
  const Lanes zero = Splat(0.0);
  for (int i = 0; i < count; i += LaneCount())
  {
    Lanes by[6];
    for (std::size_t k = 0; k < 6; ++k)
    {
      by[k] = NumberTraits<Lanes>::Load(slope[k] + i);
    }
    Lanes v[3];
    Lanes largest = zero;
    Lanes sum = zero;
    ForEachAxis(
      [&](auto c) PIXELEXACT_INLINED
      {
        const int p = 2 * ((c + 1) % 3);
        const int q = 2 * ((c + 2) % 3);
        v[c] = Splat(sign) * (by[p] * by[q + 1] - by[p + 1] * by[q]);
        largest = Max(largest, Abs(v[c]));
        sum = sum + v[c];
      });
    const LaneMask isThere = And(And(zero < largest, IsFinite(largest)), IsFinite(sum));
    Lanes squares = zero;
    ForEachAxis(
      [&](auto c) PIXELEXACT_INLINED
      {
        v[c] = v[c] / largest;
        squares = squares + v[c] * v[c];
      });
    const Lanes scale = Splat(1.0) / Sqrt(squares);
    ForEachAxis(
      [&](auto c) PIXELEXACT_INLINED { Store(Select(isThere, v[c] * scale, zero), to[c] + i); });
  }
}

const FaceNormalKernels& FaceNormalTable()
{
  static constexpr FaceNormalKernels kTable{ &MakeNormals };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FaceNormalTable);

const FaceNormalKernels& GetFaceNormalKernels()
{
  return HWY_DYNAMIC_DISPATCH(FaceNormalTable)();
}
} // namespace pixelexact
#endif
