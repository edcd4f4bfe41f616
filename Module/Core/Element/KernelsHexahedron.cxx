// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/KernelsHexahedron.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/FloatKernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
KernelSet HexahedronKernelSet(const Space& space)
{
  return SelectKernels<HexahedronModes, 1, 2, 3, 4, 5, 6, 7, 8>(space);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(HexahedronKernelSet);

KernelSet HexahedronKernels(const Space& space)
{
  return HWY_DYNAMIC_DISPATCH(HexahedronKernelSet)(space);
}
} // namespace pixelexact
#endif
