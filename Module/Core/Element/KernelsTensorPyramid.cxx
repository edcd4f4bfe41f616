// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/KernelsTensorPyramid.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/FloatKernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
KernelSet TensorPyramidKernelSet(const Space& space)
{
  return SelectKernels<TensorPyramidModes, 1, 2, 3, 4>(space);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TensorPyramidKernelSet);

KernelSet TensorPyramidKernels(const Space& space)
{
  return HWY_DYNAMIC_DISPATCH(TensorPyramidKernelSet)(space);
}
} // namespace pixelexact
#endif
