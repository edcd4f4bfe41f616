// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/StageClock.h"

namespace pixelexact
{
StageClock*& StageClock::OfThread()
{
  thread_local StageClock* clock = nullptr;
  return clock;
}

StageClock::StageClock()
  : Since(Clock::now())
{
  OfThread() = this;
}

StageClock::~StageClock()
{
  OfThread() = nullptr;
}
} // namespace pixelexact
