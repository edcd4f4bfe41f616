// SPDX-License-Identifier: BSD-3-Clause
#ifndef FreeMemory_h
#define FreeMemory_h

#include <string>

namespace pixelexact
{
/// Bytes that can be had without taking them from others: Linux's MemAvailable, elsewhere all of
/// the machine's; infinite where neither is known.
[[nodiscard]] double FreeMemory();

/// Throws Error where so many bytes are not free: what needs them, how many, how many there are,
/// and the remedy. `what` begins the message: "17 points"; `remedy` ends it: "lower the level".
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

/// Gives back what was freed and the heap keeps for later, where the C library can: after much was
/// read that is not needed again.
void ReturnFreedMemory();
} // namespace pixelexact
#endif
