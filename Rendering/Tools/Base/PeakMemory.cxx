// SPDX-License-Identifier: BSD-3-Clause
#include "Base/PeakMemory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <fstream>
#include <string>

namespace pixelexact
{
namespace
{
std::optional<double> StatusOf(const std::string& wanted)
{
  std::ifstream file("/proc/self/status");
  for (std::string name; file >> name; std::getline(file, name))
  {
    double kilobytes = 0.0;
    if (name == wanted && file >> kilobytes)
    {
      return 1024.0 * kilobytes;
    }
  }
  return std::nullopt;
}
} // namespace

PeakMemory::PeakMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush; // sets the mark back to what is resident
  if (file)
  {
    Before = StatusOf("VmRSS:");
  }
}

std::optional<double> PeakMemory::Bytes() const
{
  const std::optional<double> peak = StatusOf("VmHWM:");
  return Before && peak ? std::optional(std::max(0.0, *peak - *Before)) : std::nullopt;
}
} // namespace pixelexact
