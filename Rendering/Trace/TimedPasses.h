// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/FrameCost.h"
#include "Trace/ProgressiveFrame.h"

namespace pixelexact
{
/// Makes passes of a frame for as long as `seconds`, or until `progress` is false; the first one
/// is what `cost` expects to be made by then, and `cost` learns from all of them. At the end some
/// pass is done, which may take longer. Infinite: all at once, of which none is done when
/// `progress` ends it.
void TracePasses(
  ProgressiveFrame& passes, FrameCost& cost, double seconds, const Progress& progress);
} // namespace pixelexact
