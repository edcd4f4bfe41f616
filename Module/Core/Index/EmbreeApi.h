// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The one place that knows which Embree is there: 3 and 4 differ, for point queries, in their
// folder alone.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
