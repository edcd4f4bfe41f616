// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/KernelsTetrahedron.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/FloatKernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
KernelSet TetrahedronKernelSet(const Space& space)
{
  return SelectKernels<TetrahedronModes, 1, 2, 3, 4, 5, 6, 7, 8>(space);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TetrahedronKernelSet);

KernelSet TetrahedronKernels(const Space& space)
{
  return HWY_DYNAMIC_DISPATCH(TetrahedronKernelSet)(space);
}
} // namespace pixelexact
#endif
