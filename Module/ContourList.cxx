// SPDX-License-Identifier: BSD-3-Clause
#include "ContourList.h"

#include <algorithm>
#include <limits>

namespace pixelexact
{
bool ContourList::Set(int i, double value)
{
  if (i < 0 || At(i) == value)
  {
    return false;
  }
  Resize(std::max(i + 1, Size()));
  Values[static_cast<std::size_t>(i)] = value;
  return true;
}

double ContourList::At(int i) const
{
  return i >= 0 && i < Size() ? Values[static_cast<std::size_t>(i)]
                              : std::numeric_limits<double>::quiet_NaN();
}

bool ContourList::Resize(int number)
{
  const auto size = static_cast<std::size_t>(std::max(number, 0));
  const bool changes = size != Values.size();
  Values.resize(size, 0.0);
  return changes;
}

bool ContourList::Generate(int number, double lower, double upper)
{
  const std::vector<double> before = Values;
  Resize(number);
  const double step = number > 1 ? (upper - lower) / (number - 1) : 0.0;
  for (int i = 0; i < number; ++i)
  {
    // The last one as given, and not what rounding leaves of it.
    Values[static_cast<std::size_t>(i)] = i > 0 && i + 1 == number ? upper : lower + i * step;
  }
  return Values != before;
}
} // namespace pixelexact
