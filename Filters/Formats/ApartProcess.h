// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace pixelexact
{
/// Resources that a process may use in addition to those of its parent.
struct ApartLimits
{
  std::size_t bytes = 0; ///< of address space
  unsigned seconds = 0;  ///< of processor time
};

/// Limits for libraries that read a file of `bytes` whole.
ApartLimits LimitsForFile(std::size_t bytes);

/// Runs `work` in a copy of this process that ends with it, because libraries that read a damaged
/// file may end the program, never return, or take all memory. `what` begins the messages:
/// "the HDF5 library". Throws Error with the message of what `work` threw, InvalidData where the
/// process crashed, was ended by the library, or met a limit, and Error where none could be
/// started. The copy has one thread, and its output is discarded; what `work` changes is lost.
void RunApart(
  const ApartLimits& limits, const std::string& what, const std::function<void()>& work);
} // namespace pixelexact
