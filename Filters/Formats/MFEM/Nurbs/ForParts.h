// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace pixelexact::mfem
{
/// Calls the function for each part, from several threads.
template <class Function>
void ForParts(std::size_t parts, Function&& function)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts, 8),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        function(i);
      }
    });
}
} // namespace pixelexact::mfem
