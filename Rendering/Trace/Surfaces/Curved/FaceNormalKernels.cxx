// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/FaceNormalKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/FaceNormalKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
void MakeNormals(const Vec3& normal, const double* const slope[9], int count, double* const to[3])
{
  const Lanes n[3] = { Splat(normal.x), Splat(normal.y), Splat(normal.z) };
  const Lanes zero = Splat(0.0);
  for (int i = 0; i < count; i += LaneCount())
  {
    Lanes by[9];
    for (std::size_t k = 0; k < 9; ++k)
    {
      by[k] = NumberTraits<Lanes>::Load(slope[k] + i);
    }
    Lanes v[3];
    Lanes largest = zero;
    Lanes sum = zero;
    ForEachAxis(
      [&](auto c) PIXELEXACT_INLINED
      {
        // The cofactors of J take normals in xi to normals in space.
        const int p = 3 * ((c + 1) % 3);
        const int q = 3 * ((c + 2) % 3);
        const auto cofactor = [&](int e, int f) PIXELEXACT_INLINED
        { return by[p + e] * by[q + f] - by[p + f] * by[q + e]; };
        v[c] = n[0] * cofactor(1, 2) + n[1] * cofactor(2, 0) + n[2] * cofactor(0, 1);
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
