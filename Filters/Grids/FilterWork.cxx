// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FilterWork.h"

#include "Core/Base/Error.h"
#include "MessageWords.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <tbb/parallel_for.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <limits>

namespace pixelexact
{
namespace
{
std::string Gigabytes(double bytes)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g GB", bytes * 1e-9);
  return text;
}

/// Bytes that can be had without taking them from others: Linux's MemAvailable, elsewhere all of
/// the machine's; infinite where neither is known.
[[nodiscard]] double FreeMemory()
{
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name; file.ignore(256, '\n'))
  {
    double kilobytes = 0.0;
    if (name == "MemAvailable:" && file >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const auto size = static_cast<double>(sysconf(_SC_PAGESIZE));
  return pages > 0.0 && size > 0.0 ? pages * size : std::numeric_limits<double>::infinity();
}
/// run(begin, end) for ranges that follow each other from 0 to `count`, some hundredth of it each.
/// False where `progress` ended it.
template <class Run>
bool InSteps(std::size_t count, const StepProgress& progress, const Run& run)
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
} // namespace

bool ParallelSteps(
  std::size_t count, const StepProgress& progress, const std::function<void(std::size_t)>& work)
{
  return InSteps(count, progress,
    [&work](std::size_t begin, std::size_t end) { tbb::parallel_for(begin, end, work); });
}

bool BatchedSteps(std::size_t count, std::size_t batch, bool alone, const StepProgress& progress,
  const std::function<void(std::size_t, std::size_t)>& work)
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

int FillOutput(vtkAlgorithm* filter, vtkDataObject* output, const std::function<bool()>& fill)
{
  try
  {
    if (!fill())
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << pixelexact::Worded(error.what()));
    return 0;
  }
}

StepProgress ProgressOf(vtkAlgorithm* filter, double from, double to)
{
  return [filter, from, to](double part)
  {
    filter->UpdateProgress(from + (to - from) * part);
    return filter->GetAbortExecute() == 0;
  };
}

void RequireMemory(double bytes, const std::string& what, const std::string& remedy)
{
  const double free = FreeMemory();
  if (!(bytes <= free))
  {
    throw Error(what + " need " + Gigabytes(bytes) + " of memory, and " + Gigabytes(free) +
      " are free; " + remedy + ".");
  }
}

void ReturnFreedMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}
} // namespace pixelexact
