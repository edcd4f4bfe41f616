// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FilterWork.h"

#include "Core/Base/Error.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

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
} // namespace

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
    vtkErrorWithObjectMacro(filter, << error.what());
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
