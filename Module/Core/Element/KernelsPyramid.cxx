// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/KernelsPyramid.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
KernelSet PyramidKernelSet(const Space& space)
{
  if (space.form == Form::Tensor)
  {
    return SelectKernelSet<TensorPyramidModes, 1, 2>(space);
  }
  return SelectKernelSet<PyramidModes, 1, 2, 3, 4, 5, 6, 7, 8>(space);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(PyramidKernelSet);

KernelSet PyramidKernels(const Space& space)
{
  return HWY_DYNAMIC_DISPATCH(PyramidKernelSet)(space);
}
} // namespace pixelexact
#endif
