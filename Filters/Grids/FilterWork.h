// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterWork_h
#define FilterWork_h

#include <cstddef>
#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace pixelexact
{
/// Called by the calling thread between steps with the part done, 0 to 1; false ends the work. May
/// be empty.
using StepProgress = std::function<bool(double)>;

/// Calls work(i) for i from 0 to `count`, on all threads. False where `progress` ended it.
[[nodiscard]] bool ParallelSteps(
  std::size_t count, const StepProgress& progress, const std::function<void(std::size_t)>& work);

/// Calls work(begin, end) for ranges of at most `batch` items, on all threads, or on the calling
/// thread if `alone`. Returns false where `progress` aborted it.
[[nodiscard]] bool BatchedSteps(std::size_t count, std::size_t batch, bool alone,
  const StepProgress& progress, const std::function<void(std::size_t, std::size_t)>& work);

/// RequestData: fill() makes `output`, which is empty where it gives false, for it was aborted.
/// What it throws, also for want of memory, is the filter's error; the output is empty then too,
/// and 0 returned.
int FillOutput(vtkAlgorithm* filter, vtkDataObject* output, const std::function<bool()>& fill);

/// Returns a progress function for the work between `from` and `to` of the filter. It returns false
/// where the filter was aborted.
[[nodiscard]] StepProgress ProgressOf(vtkAlgorithm* filter, double from, double to);

/// Throws Error where `bytes` of memory are not available. The message states the need, the
/// available memory and the remedy. `what` begins it: "17 points"; `remedy` ends it: "lower the
/// level".
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

/// Returns freed memory of the heap to the system, where the C library can. Called after large
/// temporary data were freed.
void ReturnFreedMemory();
} // namespace pixelexact
#endif
