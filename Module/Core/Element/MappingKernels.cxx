// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/MappingKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/MappingKernels.h"
#include "Core/Element/Matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A Jacobian in lanes, and its cofactors as they are needed.
struct LaneJacobian
{
  Lanes m[3][3];

  [[nodiscard]] HWY_INLINE Lanes Cofactor(std::size_t i, std::size_t j) const
  {
    const std::size_t i1 = (i + 1) % 3;
    const std::size_t i2 = (i + 2) % 3;
    const std::size_t j1 = (j + 1) % 3;
    const std::size_t j2 = (j + 2) % 3;
    return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
  }
  [[nodiscard]] HWY_INLINE Lanes Determinant() const
  {
    return m[0][0] * Cofactor(0, 0) + m[0][1] * Cofactor(0, 1) + m[0][2] * Cofactor(0, 2);
  }
};

/// F at the points from `at` on, to world values.
HWY_INLINE void MapVectors(
  bool covariant, Lanes size, const LaneJacobian& J, Lanes inverseD, double* const* value, int at)
{
  const Lanes one = Splat(1.0);
  Lanes F[3];
  ForEachAxis([&](auto d) PIXELEXACT_INLINED { F[d] = NumberTraits<Lanes>::Load(value[d] + at); });
  const Lanes scale = covariant ? one / J.Determinant() : size;
  const Lanes unit = covariant ? one / size : inverseD;
  ForEachAxis(
    [&](auto i) PIXELEXACT_INLINED
    {
      Lanes row[3];
      ForEachAxis([&](auto j) PIXELEXACT_INLINED
        { row[j] = (covariant ? J.Cofactor(i, j) : J.m[i][j]) * scale; });
      if (covariant)
      {
        ForEachAxis([&](auto j) PIXELEXACT_INLINED { row[j] = row[j] * unit; });
      }
      const Lanes sum = row[0] * F[0] + row[1] * F[1] + row[2] * F[2];
      Store(covariant ? sum : sum * unit, value[i] + at);
    });
}

void ToWorld(Mapping mapping, double size, const double* const* jacobian, int count, int components,
  double* const* value)
{
  const Lanes s = Splat(size);
  for (int at = 0; at < count; at += LaneCount())
  {
    LaneJacobian J;
    ForEachAxis(
      [&](auto c) PIXELEXACT_INLINED
      {
        ForEachAxis([&](auto d) PIXELEXACT_INLINED
          { J.m[c][d] = NumberTraits<Lanes>::Load(jacobian[3 * c + d] + at); });
      });
    // One factor after the other: the cube of a size may overflow where the quotient does not.
    const Lanes inverseD = Splat(1.0) / J.Determinant() / s / s / s;
    if (mapping != Mapping::Density)
    {
      MapVectors(mapping == Mapping::Covariant, s, J, inverseD, value, at);
      continue;
    }
    for (int c = 0; c < components; ++c)
    {
      Store(NumberTraits<Lanes>::Load(value[c] + at) * inverseD, value[c] + at);
    }
  }
}

const MappingKernels& MappingKernelSet()
{
  static constexpr MappingKernels kKernels{ &ToWorld };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(MappingKernelSet);

const MappingKernels& GetMappingKernels()
{
  return HWY_DYNAMIC_DISPATCH(MappingKernelSet)();
}
} // namespace pixelexact
#endif
