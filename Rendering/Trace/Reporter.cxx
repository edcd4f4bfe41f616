// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Reporter.h"

namespace pixelexact
{
Reporter::Reporter(const Progress& progress, int total, Deadline end)
  : progress_(progress)
  , Total(total)
  , End(end)
  , Caller(std::this_thread::get_id())
{
}

bool Reporter::HasTime()
{
  if (!Begun.exchange(true) || Aborted)
  {
    return !Aborted;
  }
  if (End != kNoDeadline && std::chrono::steady_clock::now() >= End)
  {
    Aborted = true;
  }
  return !Aborted;
}

void Reporter::TileDone()
{
  const int done = ++Done;
  // VTK's progress may be reported from the calling thread only.
  if (progress_ && std::this_thread::get_id() == Caller &&
    !progress_(static_cast<double>(done) / Total))
  {
    Aborted = true;
  }
}
} // namespace pixelexact
