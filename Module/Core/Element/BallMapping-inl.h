// SPDX-License-Identifier: BSD-3-Clause
// Maps the values of a field to the world, in balls. Included once per instruction set.
#if defined(PIXELEXACT_BALL_MAPPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_BALL_MAPPING_INL_H
#undef PIXELEXACT_BALL_MAPPING_INL_H
#else
#define PIXELEXACT_BALL_MAPPING_INL_H
#endif

#include "Core/Element/Mesh.h"
#include "Core/Math/Ball-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Maps F's values to world values, up to powers of the element's size.
HWY_INLINE void MapBalls(Mapping mapping, const Ball* jacobian, int components, Ball* value)
{
  const auto minor = [jacobian](int i, int j)
  {
    const auto at = [&](int k, int l) { return jacobian[3 * ((i + k) % 3) + (j + l) % 3]; };
    return NegMulAdd(at(1, 2), at(2, 1), at(1, 1) * at(2, 2));
  };
  const Ball determinant =
    MulAdd(jacobian[0], minor(0, 0), MulAdd(jacobian[1], minor(0, 1), jacobian[2] * minor(0, 2)));
  if (mapping == Mapping::Density)
  {
    for (int c = 0; c < components; ++c)
    {
      value[c] = value[c] / determinant;
    }
    return;
  }
  const Ball F[3] = { value[0], value[1], value[2] };
  for (int i = 0; i < 3; ++i)
  {
    // Row i of J, or of its cofactors, which are det J times J^-T.
    const auto factor = [&](int j)
    { return mapping == Mapping::Contravariant ? jacobian[3 * i + j] : minor(i, j); };
    value[i] = MulAdd(factor(0), F[0], MulAdd(factor(1), F[1], factor(2) * F[2])) / determinant;
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
