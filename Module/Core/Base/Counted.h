// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pixelexact
{
/// "1 element", "2 elements": a number of things whose plural takes an s.
template <class Integer>
std::string Counted(Integer count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}
} // namespace pixelexact
