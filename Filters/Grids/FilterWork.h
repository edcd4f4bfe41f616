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

/// Calls work(begin, end) for ranges of at most `batch`, on all threads or by the calling one
/// alone. False where `progress` ended it.
[[nodiscard]] bool BatchedSteps(std::size_t count, std::size_t batch, bool alone,
  const StepProgress& progress, const std::function<void(std::size_t, std::size_t)>& work);

/// RequestData: fill() makes `output`, which is empty where it gives false, for it was aborted.
/// What it throws, also for want of memory, is the filter's error; the output is empty then too,
/// and 0 returned.
int FillOutput(vtkAlgorithm* filter, vtkDataObject* output, const std::function<bool()>& fill);

/// Tells of work that is the part from `from` to `to` of the filter's. False where it was aborted.
[[nodiscard]] StepProgress ProgressOf(vtkAlgorithm* filter, double from, double to);

/// Throws Error where so many bytes are not free: what needs them, how many, how many there are,
/// and the remedy. `what` begins the message: "17 points"; `remedy` ends it: "lower the level".
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

/// Gives back what was freed and the heap keeps for later, where the C library can: after much was
/// read that is not needed again.
void ReturnFreedMemory();
} // namespace pixelexact
#endif
