// SPDX-License-Identifier: BSD-3-Clause
#ifndef LargestOfAll_h
#define LargestOfAll_h

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace pixelexact
{
/// By name the largest numbers of all processes, which all must call it.
template <class Number>
std::map<std::string, Number> LargestOfAll(
  const std::map<std::string, Number>& own, vtkMultiProcessController* processes)
{
  using Numbers = std::map<std::string, Number>;
  const auto write = [](const Numbers& numbers)
  {
    vtkMultiProcessStream stream;
    stream << static_cast<int>(numbers.size());
    for (const auto& [name, number] : numbers)
    {
      stream << name << number;
    }
    return stream;
  };
  Numbers largest;
  const auto join = [&largest](vtkMultiProcessStream& stream)
  {
    int count = 0;
    stream >> count;
    for (int i = 0; i < count; ++i)
    {
      std::string name;
      Number number = 0;
      stream >> name >> number;
      const auto [at, isNew] = largest.try_emplace(name, number);
      at->second = std::max(at->second, number);
    }
  };
  std::vector<vtkMultiProcessStream> received;
  processes->Gather(write(own), received, 0);
  for (vtkMultiProcessStream& stream : received)
  {
    join(stream);
  }
  vtkMultiProcessStream told = write(largest);
  processes->Broadcast(told, 0);
  join(told);
  return largest;
}
} // namespace pixelexact
#endif
