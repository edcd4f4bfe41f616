// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterWork_h
#define FilterWork_h

#include "Grids/ParallelSteps.h"

#include <functional>

class vtkAlgorithm;
class vtkDataObject;

namespace pixelexact
{
/// RequestData: fill() makes `output`, which is empty where it gives false, for it was aborted.
/// What it throws, also for want of memory, is the filter's error; the output is empty then too,
/// and 0 returned.
int FillOutput(vtkAlgorithm* filter, vtkDataObject* output, const std::function<bool()>& fill);

/// Tells of work that is the part from `from` to `to` of the filter's. False where it was aborted.
[[nodiscard]] StepProgress ProgressOf(vtkAlgorithm* filter, double from, double to);
} // namespace pixelexact
#endif
