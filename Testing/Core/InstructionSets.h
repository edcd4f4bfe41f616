// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <hwy/targets.h>

#include <gtest/gtest.h>

#include <string>

namespace pixelexact::testing
{
/// check() once for each instruction set that the processor has and kernels are made for, which are
/// in use meanwhile.
template <class Check>
void OnEveryInstructionSet(const Check& check)
{
  int sets = 0;
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1)
  {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    if (std::string(InstructionSet()) == hwy::TargetName(rest & -rest))
    {
      ++sets;
      SCOPED_TRACE(InstructionSet());
      check();
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  EXPECT_GE(sets, 1);
}
} // namespace pixelexact::testing
