// SPDX-License-Identifier: BSD-3-Clause
#ifndef CommonWidths_h
#define CommonWidths_h

#include "PackedArrays.h"

class vtkMultiProcessController;

namespace pixelexact
{
/// The largest widths of all processes, which all must call it; those given where there is no
/// controller, or one process.
PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller);
} // namespace pixelexact
#endif
