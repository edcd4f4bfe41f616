// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/InstructionSet.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Kernels.h"
#include "Core/Math/Lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
const char* TargetName()
{
  return hwy::TargetName(HWY_TARGET);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TargetName);

const char* InstructionSet()
{
  return HWY_DYNAMIC_DISPATCH(TargetName)();
}
} // namespace pixelexact
#endif
