// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterWork_h
#define FilterWork_h

#include <tbb/parallel_for.h>

#include <algorithm>
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

/// run(begin, end) for ranges that follow each other from 0 to `count`, some hundredth of it each.
/// False where `progress` ended it.
template <class Run>
[[nodiscard]] bool InSteps(std::size_t count, const StepProgress& progress, const Run& run)
{
  constexpr std::size_t kSteps = 100;
  const std::size_t step = std::max<std::size_t>(1, (count + kSteps - 1) / kSteps);
  for (std::size_t begin = 0; begin < count; begin += step)
  {
    const std::size_t end = std::min(count, begin + step);
    run(begin, end);
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

/// work(i) for i from 0 to `count`, on all threads. False where `progress` ended it.
template <class Work>
[[nodiscard]] bool ParallelSteps(std::size_t count, const StepProgress& progress, const Work& work)
{
  return InSteps(count, progress,
    [&work](std::size_t begin, std::size_t end) { tbb::parallel_for(begin, end, work); });
}

/// work(begin, end) for ranges of `batch` at most, on all threads or by the calling one alone.
/// False where `progress` ended it.
template <class Work>
[[nodiscard]] bool BatchedSteps(
  std::size_t count, std::size_t batch, bool alone, const StepProgress& progress, const Work& work)
{
  return InSteps(count, progress,
    [&](std::size_t begin, std::size_t end)
    {
      const auto one = [&](std::size_t b)
      { work(begin + b * batch, std::min(end, begin + (b + 1) * batch)); };
      const std::size_t batches = (end - begin + batch - 1) / batch;
      if (!alone)
      {
        tbb::parallel_for(std::size_t{ 0 }, batches, one);
        return;
      }
      for (std::size_t b = 0; b < batches; ++b)
      {
        one(b);
      }
    });
}

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
