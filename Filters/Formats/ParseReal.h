// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace pixelexact
{
/// As ParseWhole; numbers beyond the range of doubles become zero or infinite, as the C library has
/// it.
bool ParseReal(std::string_view word, double& value);
} // namespace pixelexact
